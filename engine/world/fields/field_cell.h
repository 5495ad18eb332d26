#pragma once

// Finds the cell at a point. Private to engine/world.

#include <graze/bvh/pose.h>
#include <graze/engine/world/fields/field_data.h>

namespace graze {

/// Returns the material of the triangle that is nearest to a point of the world, metres, by
/// nearest_point() of the field's mesh; of several that of the least number.
std::uint8_t material_near(const HeightField& field, const Pose& pose,
                           const Eigen::Vector3d& point);

}  // namespace graze
