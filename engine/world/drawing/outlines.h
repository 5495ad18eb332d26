#pragma once

#include <graze/engine/world/placed_shape.h>
#include <graze/engine/world/world_drawing.h>

#include <functional>

namespace graze {

/// Takes one segment, in the world's frame.
using TakeLine = std::function<void(const Eigen::Vector3d& from, const Eigen::Vector3d& to)>;

/// Edges, and circles and profiles of what is round, in the shape's frame and then placed.
void outline(const PlacedShapeView& shape, const WorldDrawingSettings& settings,
             const TakeLine& take);

/// The twelve edges of a box.
void outline(const Aabb& box, const TakeLine& take);

}  // namespace graze
