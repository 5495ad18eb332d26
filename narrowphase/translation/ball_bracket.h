#pragma once

#include <graze/bvh/sphere.h>
#include <graze/narrowphase/triangle.h>
#include <Eigen/Core>

#include <optional>

namespace graze::narrowphase {

/// Holds doubles between which a ball that goes straight meets a triangle first: it is proved that
/// they are apart up to `low`, and that they meet at `high`, which is at most 1.
struct BallBracket {
  double low;
  double high;
  Eigen::Vector3d normal;  ///< roughly the direction from the triangle to the centre at that time;
                           ///< of any length
};

/// Brackets the time when the ball, moved by t d, meets a triangle from which it is apart at t = 0.
/// Returns nothing where rounded arithmetic cannot tell, or where they do not meet up to t = 1.
std::optional<BallBracket> bracket_meeting(const Triangle& triangle, const Sphere& ball,
                                           const Eigen::Vector3d& d);

}  // namespace graze::narrowphase
