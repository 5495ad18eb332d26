#pragma once

// Finds how far a point is from a triangle, in less time than the distance of a triangle and one
// that is a point takes. Private to the library.

#include <graze/narrowphase/predicates/verdict.h>
#include <graze/narrowphase/triangle_distance.h>

namespace graze::narrowphase {

/// Holds the point of a triangle that is nearest to a given one.
struct PointDistance {
  double distance;
  Eigen::Vector3d nearest;
  Feature feature;  ///< the feature of the triangle that holds `nearest` before rounding
  Stage stage;      ///< Triage only if no exact stage was asked for anything
};

/// Returns the nearest point within the bounds of law 7; the order of the triangle's corners
/// changes no bit (law 4). All must be finite.
PointDistance decide_distance(const Eigen::Vector3d& point, const Triangle& triangle);

}  // namespace graze::narrowphase
