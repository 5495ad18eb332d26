#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

namespace graze::bvh {

/// A ball through up to four points that determine it, in local coordinates.
struct SupportBall {
  Eigen::Vector3d centre;
  double squared_radius;  ///< square of a radius that covers the support
  std::array<Eigen::Vector3d, 4> support;
  int support_size;
};

/// Returns the smallest ball around a few points, in a time that is linear in practice, by
/// Gärtner's pivoting. The ball of the support so far takes in the point farthest from it, until
/// none is outside by more than rounding. Coordinates must be around 1, as LocalPoints gives them.
SupportBall smallest_ball(std::span<const Eigen::Vector3d> points);

/// Points count as inside a ball up to this relative excess of the squared distance: the noise of
/// a centre computed from four points. It only decides when to stop looking for a smaller ball.
inline constexpr double kBallTolerance = 0x1p-46;

}  // namespace graze::bvh
