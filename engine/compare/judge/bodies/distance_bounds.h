#pragma once

#include <graze/engine/compare/judge/shape_judge.h>

#include <optional>
#include <string>

namespace graze::compare {

/// By how much a plane at right angles to the direction from A to B keeps the two apart; of
/// half-spaces and planes across their own direction. Below 0 it does not.
double proved_gap(const PlacedBody& a, const PlacedBody& b, Eigen::Vector3d direction);

/// The best of that and of planes across the axes of the two: between faces that nearly touch the
/// direction of the nearest points says little.
double best_proved_gap(const PlacedBody& a, const PlacedBody& b, const Eigen::Vector3d& proposed);

/// The distance where it is a matter of points and triangles, rounded: two balls, two meshes, a
/// mesh and a ball.
std::optional<double> exact_distance(const PlacedBody& a, const PlacedBody& b);

/// The largest coordinate of the placed shape.
double largest_of(const PlacedBody& body);

/// How far off a distance of two shapes may be that is a search's: kTouchTolerance, law 11's share
/// of a scale, of four times the largest coordinate, and kTouchUlps of it for what rounds; metres.
double distance_tolerance(const PlacedBody& a, const PlacedBody& b);

/// What is proved of the distance of two placed shapes, metres.
struct DistanceBounds {
  double least = 0;  ///< a plane has them so far on different sides
  double most = 0;   ///< two points of them are so near; infinite: none are known
  double slack = 0;  ///< so far off the shapes these points may be
  bool is_exact = false;

  /// "a plane proves 0.24 m at least, two points 0.25 m at most, to 1e-10 m".
  std::string text() const;
};

/// The library proposes a direction and two points; what the shapes are decides what these prove,
/// points to distance_tolerance(). Nothing is looked at but the distance: shapes that meet have one
/// of 0 at most.
DistanceBounds distance_bounds(const PlacedBody& a, const PlacedBody& b);

}  // namespace graze::compare
