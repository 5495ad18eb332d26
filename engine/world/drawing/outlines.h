#pragma once

#include <graze/engine/world/placed_shape.h>
#include <graze/engine/world/world_drawing.h>

#include <functional>

namespace graze {

/// A function that takes one segment, in the world's frame.
using TakeLine = std::function<void(const Eigen::Vector3d& from, const Eigen::Vector3d& to)>;

/// Draws the edges of a shape, and the circles and profiles of round sides.
void outline(const PlacedShapeView& shape, const WorldDrawingSettings& settings,
             const TakeLine& take);

/// Draws the twelve edges of a box.
void outline(const Aabb& box, const TakeLine& take);

}  // namespace graze
