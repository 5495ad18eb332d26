#pragma once

// Lines at convex shapes by their definitions, in numbers of 1000 bits, and distances of points.

#include <graze/bvh/pose.h>
#include <graze/engine/world/shape.h>

#include <gmpxx.h>

#include <Eigen/Core>
#include <array>
#include <optional>

namespace graze::tests {

inline constexpr int kBits = 1024;

struct WidePoint {
  std::array<mpf_class, 3> at;
};

/// R^-1 (p - t), R being what the pose has, and R^-1 d.
WidePoint point_into(const Pose& pose, const Eigen::Vector3d& p);
WidePoint direction_into(const Pose& pose, const Eigen::Vector3d& d);

/// Which o + s d are in a shape, all in its own frame: the first and the last s, if any. For every
/// kind but half-spaces, hulls and meshes.
struct WideStretch {
  mpf_class enter, exit;
};
std::optional<WideStretch> stretch_in(const Shape& shape, const WidePoint& o, const WidePoint& d);

/// How far a point of the shape's own frame is from the shape, 0 inside; off by a few u of the
/// sizes and the point's coordinates.
double distance_to(const Shape& shape, const WidePoint& p);

/// The largest n . x over the shape in its own frame.
double reach_along(const Shape& shape, const Eigen::Vector3d& n);

}  // namespace graze::tests
