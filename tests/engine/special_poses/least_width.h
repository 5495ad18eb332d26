#pragma once

// The least width by which two convex shapes reach past each other, by trying directions. Shares
// nothing with the library's solvers but the shapes.

#include <graze/bvh/pose.h>
#include <graze/engine/world/shape.h>

#include <cstddef>

namespace graze::tests {

struct PlacedPair {
  Shape a;
  Shape b;
  Pose pose_a;
  Pose pose_b;
};

/// By how much A reaches past B along a unit direction from A to B, metres; negative where the
/// direction parts them. Infinite for a half-space along any direction but its own.
double width_along(const PlacedPair& pair, const Eigen::Vector3d& direction);

struct LeastWidth {
  double width;  ///< metres: no less than the least over all directions
  Eigen::Vector3d direction;
};

/// The least of many directions: a spiral over the sphere, axes, their products, normals of cones
/// and hulls, and `hints`, the best of them refined by a search that halves its steps. From above
/// alone: that it is the least is likely, not proved.
LeastWidth least_width(const PlacedPair& pair, std::size_t directions,
                       std::initializer_list<Eigen::Vector3d> hints = {});

/// The distance of the farthest point of a shape from its middle; 0 of a half-space.
double size_about_middle(const Shape& shape);

/// The centre of a sphere or an ellipsoid, the middle of the box around a hull's corners or a
/// mesh's vertices, the frame's origin of all others: in the common frame.
Eigen::Vector3d placed_middle(const Shape& shape, const Pose& pose);

/// The scale of a pair as shape_pairs.h defines it.
double scale_of(const PlacedPair& pair);

/// Of the two, half-spaces aside.
double smaller_size(const PlacedPair& pair);

}  // namespace graze::tests
