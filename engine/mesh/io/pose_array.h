#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <graze/engine/pose_text.h>

// These read poses in numpy's own format, `numpy.save()`: float64 in C order, n x 3 x 4 or n x 4 x
// 4. See NEP 1, "A simple file format for NumPy arrays" (2007).

namespace graze::mesh_io {

/// True if a file begins as such arrays do.
bool is_array(std::string_view bytes);

/// Says where the poses of such an array stand in its file.
struct PoseArrayLayout {
  std::size_t count = 0;
  std::size_t rows = 0;   ///< the rows of a pose, 3 or 4
  std::size_t start = 0;  ///< the first byte of the first pose

  std::size_t bytes_of_pose() const { return rows * 4 * sizeof(double); }
};

/// The number of first bytes of a file that hold the header of every array of poses that numpy
/// writes.
inline constexpr std::size_t kMostArrayHeader = std::size_t{1} << 16;

/// Returns the layout of a file that begins with these bytes and has `size` of them. Throws
/// PoseError `name: why` for another type, order or shape, and for more or fewer numbers than that
/// says.
PoseArrayLayout layout_of_array(std::string_view begin, std::size_t size, const std::string& name);

/// Returns the pose in these bytes, which are those of the pose `index` alone. Throws PoseError
/// `name:N: why`, N counted from 1, for one that is not rigid.
Pose pose_of_array(std::string_view bytes, std::size_t index, const std::string& name);

/// Returns all poses of an array, numbered from 1 in place of lines. Throws PoseError as these do,
/// and for an array of none.
std::vector<PoseLine> poses_of_array(std::string_view bytes, const std::string& name);

}  // namespace graze::mesh_io
