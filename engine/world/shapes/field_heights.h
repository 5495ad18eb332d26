#pragma once

// Finds heights of a height field above a plane. Private to engine/world.

#include <graze/engine/world/fields/field_data.h>
#include <graze/engine/world/shapes/placed_core.h>

#include <cstdint>

namespace graze {

/// A vertex of a height field, and its height above a plane.
struct FieldVertex {
  double height;  ///< metres
  std::uint32_t column, row;
};

/// Returns the vertex that is lowest above the plane of a half-space, whose frame has the field's
/// origin. The height is that of the field's mesh, bit for bit. Squares of cells that are surely
/// higher are skipped.
FieldVertex lowest_of(const HeightFieldData& field, const Pose& pose, const PlacedHalfSpace& plane);

/// Returns the height of a vertex above the plane, as that of the field's mesh.
double height_of(const HeightFieldData& field, const Pose& pose, const PlacedHalfSpace& plane,
                 std::uint32_t column, std::uint32_t row);

}  // namespace graze
