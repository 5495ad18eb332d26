#pragma once

#include <graze/engine/compare/judge/shape_judge.h>

namespace graze::compare {

/// How far B must go along a unit direction until a plane across it parts the two, metres; below 0
/// one does already.
double needed_along(const PlacedBody& a, const PlacedBody& b, const Eigen::Vector3d& n);

/// How far a point that both share is below both surfaces, where the library finds one: so deep
/// they are in each other, at least. Below 0 there is none.
double shared_depth(const PlacedBody& a, const PlacedBody& b);

/// So far, metres, a depth may be from what parts the two: for graze what find_contacts() grants
/// itself, with contacts as far apart as the smaller shape; for others, which compute partly in
/// float, 1e-5 of its size.
double parting_tolerance(const PlacedBody& a, const PlacedBody& b, bool is_graze);

}  // namespace graze::compare
