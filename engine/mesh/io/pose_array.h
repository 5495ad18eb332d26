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

/// The poses of the array, numbered from 1 in place of lines. Throws PoseError `name: why`, or
/// `name:N: why` of the N-th pose: for another type, order or shape, for more or fewer numbers than
/// that says, and for a pose that is not rigid.
std::vector<PoseLine> poses_of_array(std::string_view bytes, const std::string& name);

}  // namespace graze::mesh_io
