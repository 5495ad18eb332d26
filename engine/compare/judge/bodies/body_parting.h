#pragma once

#include <graze/engine/compare/judge/meshes/parts_review.h>
#include <graze/engine/compare/judge/shape_judge.h>

#include <string>

namespace graze::compare {

/// True for a mesh or a height field, which other ways lead out of than out of its hull.
bool is_surface(const PlacedBody& body);

/// Returns how far B must go along a unit direction until a plane across it parts the two, metres;
/// below 0 if one does already.
double needed_along(const PlacedBody& a, const PlacedBody& b, const Eigen::Vector3d& n);

/// Returns how far a depth may be from what parts the two, metres: for graze what find_contacts()
/// grants itself, with contacts as far apart as the smaller shape; for others, which compute partly
/// in float, 1e-5 of its size.
double parting_tolerance(const PlacedBody& a, const PlacedBody& b, bool is_graze);

/// Describes a translation of B that is said to part the two: its direction, of any length but
/// zero, its length, and how far off that may be, metres.
struct WayOut {
  Eigen::Vector3d direction;
  double length = 0;
  double tolerance = 0;
};

/// Reviews whether the two are apart, or merely touch, where B has gone. If not, they must go as
/// far as the shortest way out is from there.
PartsReview review_parted(const PlacedBody& a, const PlacedBody& b, const WayOut& way_out);

/// Reviews whether another direction would do sooner, by least_parting(), and for two convex bodies
/// whether none leads out so soon. Two boxes are granted a twentieth more. Adds both bounds to the
/// truth. A translation that parts the hulls of surfaces parts the surfaces, but that does not
/// prove that none does sooner. One that is too long is ErrorClass::NotLeast.
PartsReview review_least(const PlacedBody& a, const PlacedBody& b, const WayOut& way_out,
                         std::string& truth);

}  // namespace graze::compare
