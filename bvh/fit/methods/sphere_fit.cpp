#include <graze/bvh/error.h>
#include <graze/bvh/fit/methods/extremal_pairs.h>
#include <graze/bvh/fit/methods/local_points.h>
#include <graze/bvh/fit/methods/support_ball.h>
#include <graze/bvh/fit/sphere_fit.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace graze {
namespace {

using bvh::ExtremalPair;
using bvh::FarPoint;
using bvh::LocalPoints;

constexpr std::array<bvh::Direction, 3> kCoordinateAxes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// A centre that doubles can name, and the farthest point from it in local units.
struct NamedBall {
  Eigen::Vector3d centre;
  double squared_radius;
};

NamedBall ball_around(const LocalPoints& points, const Eigen::Vector3d& local_centre) {
  const Aabb& bounds = points.bounds();
  const Eigen::Vector3d centre =
      points.to_world(local_centre).cwiseMax(bounds.min).cwiseMin(bounds.max);
  return {centre, bvh::farthest_point(points, points.to_local(centre)).squared_distance};
}

/// Returns the radius, rounded up. Let u = 2^-53 and H the largest local coordinate, which the
/// radius is at least. Point and centre are rounded on their way into the frame, by at most u H in
/// each coordinate, and their difference d by u d: together they move the offset of the point by no
/// more than sqrt(3) 2 u H + u |d|, below 4.5 u of the radius. Squares, sums and root lose another
/// 3.5 u (three roundings of a square, halved, the root's and one for second order), and the
/// product below u. That is 9 u of the 16 u that are added. The scaling by a power of two is exact,
/// but where it ends in denormals: there it is looked at.
double rounded_up_radius(const LocalPoints& points, double squared_radius) {
  const double local = std::sqrt(squared_radius) * (1 + 0x1p-49);
  double radius = std::ldexp(local, points.frame().exponent);
  if (!std::isfinite(radius)) throw InputError("points too far apart: their sphere overflows");
  if (std::ldexp(radius, -points.frame().exponent) < local) {
    radius = std::nextafter(radius, std::numeric_limits<double>::infinity());
  }
  return radius;
}

Sphere to_sphere(const LocalPoints& points, const NamedBall& ball) {
  return {ball.centre, rounded_up_radius(points, ball.squared_radius)};
}

/// Returns Ritter's centre: the ball over the widest of the three extremal pairs grows towards each
/// point outside, just far enough.
Eigen::Vector3d ritter_centre(const LocalPoints& points, std::span<const ExtremalPair> extremal) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double squared = -1;
  for (const ExtremalPair& pair : extremal) {
    const Eigen::Vector3d low = points.point(pair.low);
    const Eigen::Vector3d half = 0.5 * (points.point(pair.high) - low);
    if (half.squaredNorm() > squared) {
      squared = half.squaredNorm();
      centre = low + half;
    }
  }
  double radius = std::sqrt(squared);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double dx = points.axis(0)[i] - centre.data()[0];
    const double dy = points.axis(1)[i] - centre.data()[1];
    const double dz = points.axis(2)[i] - centre.data()[2];
    const double square = dx * dx + dy * dy + dz * dz;
    if (square <= squared) continue;
    const double distance = std::sqrt(square);
    const double step = (distance - radius) / (2 * distance);
    centre += step * Eigen::Vector3d{dx, dy, dz};
    radius = 0.5 * (radius + distance);
    squared = radius * radius;
  }
  return centre;
}

/// Returns the centre of the smallest ball: the smallest ball around a few of the points takes in
/// the point that is farthest outside, until none is. Each step finds a new point, so it ends; in
/// practice after about five.
Eigen::Vector3d minimal_centre(const LocalPoints& points, std::span<const ExtremalPair> extremal,
                               const FarPoint& far_from_ritter) {
  std::vector<std::size_t> indices{far_from_ritter.index};
  for (const ExtremalPair& pair : extremal)
    indices.insert(indices.end(), {pair.low, pair.high});
  std::vector<Eigen::Vector3d> few;
  few.reserve(indices.size());
  for (std::size_t i : indices)
    few.push_back(points.point(i));
  Eigen::Vector3d best = few[0];
  double best_squared = std::numeric_limits<double>::infinity();
  while (true) {
    const bvh::SupportBall ball = bvh::smallest_ball(few);
    const FarPoint far = bvh::farthest_point(points, ball.centre);
    if (far.squared_distance < best_squared) {
      best_squared = far.squared_distance;
      best = ball.centre;
    }
    if (far.squared_distance <= ball.squared_radius * (1 + bvh::kBallTolerance)) return best;
    if (std::find(indices.begin(), indices.end(), far.index) != indices.end()) return best;
    indices.push_back(far.index);
    few.push_back(points.point(far.index));
  }
}

}  // namespace

Sphere ritter_sphere(std::span<const Eigen::Vector3d> points) {
  return bvh::in_standard_arithmetic([&]() -> Sphere {
    const LocalPoints local(points);
    if (local.is_single()) return {points.front(), 0};
    return to_sphere(
        local,
        ball_around(local, ritter_centre(local, bvh::extremal_pairs(local, kCoordinateAxes))));
  });
}

Sphere bounding_sphere(std::span<const Eigen::Vector3d> points) {
  return bvh::in_standard_arithmetic([&]() -> Sphere {
    const LocalPoints local(points);
    if (local.is_single()) return {points.front(), 0};
    const std::vector<ExtremalPair> extremal = bvh::extremal_pairs(local, kCoordinateAxes);
    const Eigen::Vector3d centre = ritter_centre(local, extremal);
    const NamedBall ritter = ball_around(local, centre);
    const FarPoint far = bvh::farthest_point(local, centre);
    const NamedBall minimal = ball_around(local, minimal_centre(local, extremal, far));
    return to_sphere(local, minimal.squared_radius <= ritter.squared_radius ? minimal : ritter);
  });
}

}  // namespace graze
