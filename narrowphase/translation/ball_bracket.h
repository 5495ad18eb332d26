#pragma once

#include <graze/bvh/sphere.h>
#include <graze/narrowphase/triangle.h>
#include <Eigen/Core>

#include <optional>

namespace graze::narrowphase {

/// Doubles between which a ball that goes straight meets a triangle first: it is proved that they
/// are apart up to `low`, and that they meet at `high`, which is at most 1.
struct BallBracket {
  double low;
  double high;
  Eigen::Vector3d normal;  ///< roughly, from the triangle to the centre then; of any length
};

/// Of the ball, moved by t d, and a triangle from which it is apart at t = 0. Nothing where rounded
/// arithmetic cannot tell, or where they do not meet up to t = 1.
std::optional<BallBracket> bracket_meeting(const Triangle& triangle, const Sphere& ball,
                                           const Eigen::Vector3d& d);

}  // namespace graze::narrowphase
