#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <graze/engine/pose_text.h>

// Poses in numpy's own format, `numpy.save()`: float64 in C order, n x 3 x 4 or n x 4 x 4. NEP 1,
// "A simple file format for NumPy arrays" (2007).

namespace graze::mesh_io {

/// Whether a file begins as such arrays do.
bool is_array(std::string_view bytes);

/// Where the poses of such an array stand in its file.
struct PoseArrayLayout {
  std::size_t count = 0;
  std::size_t rows = 0;   ///< 3 or 4
  std::size_t start = 0;  ///< the byte of the first

  std::size_t bytes_of_pose() const { return rows * 4 * sizeof(double); }
};

/// So many first bytes of a file hold the header of every array of poses that numpy writes.
inline constexpr std::size_t kMostArrayHeader = std::size_t{1} << 16;

/// Of a file that begins with these bytes and has `size` of them. Throws PoseError `name: why` for
/// another type, order or shape, and for more or fewer numbers than that says.
PoseArrayLayout layout_of_array(std::string_view begin, std::size_t size, const std::string& name);

/// The pose in these bytes, which are those of the pose `index` alone. Throws PoseError `name:N:
/// why`, N counted from 1, for one that is not rigid.
Pose pose_of_array(std::string_view bytes, std::size_t index, const std::string& name);

/// All its poses, numbered from 1 in place of lines. Throws PoseError as these do, and for an
/// array of none.
std::vector<PoseLine> poses_of_array(std::string_view bytes, const std::string& name);

}  // namespace graze::mesh_io
