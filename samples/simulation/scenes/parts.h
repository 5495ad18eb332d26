#pragma once

#include <Eigen/Geometry>

#include "samples/simulation/scenes/scene.h"
#include "samples/simulation/solid_meshes.h"

namespace graze::samples {

/// Returns the shape itself, or the closed mesh of its surface.
Shape as(Surface surface, const Shape& shape, const Fineness& fineness = {});

/// Returns "shape" or "mesh", for the names of scenes.
const char* name_of(Surface surface);

/// Return a pose that moves a body, and before turns it, radians about an axis.
Pose at(const Eigen::Vector3d& place);
Pose at(const Eigen::Vector3d& place, double radians, const Eigen::Vector3d& axis);

/// Returns a body that never moves: a slab with its upper side at z = 0, so many metres from the
/// middle to each side, and as a mesh of so many squares along each.
SceneBody floor_of(Surface surface, double half_width = 3, int cells = 6);

/// Returns a drum that six corners above and six below span, the upper ones turned by half an
/// angle: sides are triangles, both ends are flat.
ConvexHull drum(double radius, double half_height);

}  // namespace graze::samples
