#pragma once

#include <graze/engine/python/binding/arguments/arrays.h>

#include <graze/engine/mesh/voxel_grid.h>

namespace graze::python {

/// Returns a grid of an origin, an edge and three counts, checked. Throws InputError for an invalid
/// one.
VoxelGrid grid_from(py::handle origin, py::handle edge, py::handle counts);

}  // namespace graze::python
