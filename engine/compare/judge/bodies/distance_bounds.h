#pragma once

#include <graze/engine/compare/judge/shape_judge.h>

#include <optional>
#include <string>

namespace graze::compare {

/// Returns by how much a plane at right angles to the direction from A to B keeps the two apart;
/// for half-spaces and planes it is across their own direction. Below 0 it does not.
double proved_gap(const PlacedBody& a, const PlacedBody& b, Eigen::Vector3d direction);

/// Returns the best of that and of planes across the axes of the two: between faces that nearly
/// touch the direction of the nearest points says little.
double best_proved_gap(const PlacedBody& a, const PlacedBody& b, const Eigen::Vector3d& proposed);

/// Returns the distance where points and triangles tell it, rounded: of two balls, two meshes, a
/// mesh and a ball.
std::optional<double> exact_distance(const PlacedBody& a, const PlacedBody& b);

/// Returns the largest coordinate of the placed shape.
double largest_of(const PlacedBody& body);

/// Returns how far off the distance of two shapes may be that a search finds, metres:
/// kTouchTolerance, law 11's share of a scale, of four times the largest coordinate, and kTouchUlps
/// of that for rounding.
double distance_tolerance(const PlacedBody& a, const PlacedBody& b);

/// Holds what is proved of the distance of two placed shapes, metres.
struct DistanceBounds {
  double least = 0;  ///< a plane has them this far on different sides
  double most = 0;   ///< two points of them are this near; infinite if none are known
  double slack = 0;  ///< how far off the shapes these points may be
  bool is_exact = false;

  /// Returns "a plane proves 0.24 m at least, two points 0.25 m at most, to 1e-10 m".
  std::string text() const;
};

/// Finds the bounds. The library proposes a direction and two points; what the shapes are decides
/// what these prove, where points count to distance_tolerance(). Nothing is looked at but the
/// distance: shapes that meet have one of 0 at most.
DistanceBounds distance_bounds(const PlacedBody& a, const PlacedBody& b);

}  // namespace graze::compare
