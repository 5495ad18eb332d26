#pragma once

#include <graze/engine/compare/judge/shape_judge.h>

namespace graze::compare {

/// How far B must go along a unit direction until a plane across it parts the two, metres; below 0
/// if one does already.
double needed_along(const PlacedBody& a, const PlacedBody& b, const Eigen::Vector3d& n);

/// A lower bound of how deep the two are in each other, metres: how far below both surfaces a point
/// lies that they share. Below 0 where the library finds no such point.
double shared_depth(const PlacedBody& a, const PlacedBody& b);

/// How far a depth may be from what parts the two, metres: for graze what find_contacts() grants
/// itself, with contacts as far apart as the smaller shape; for others, which compute partly in
/// float, 1e-5 of its size.
double parting_tolerance(const PlacedBody& a, const PlacedBody& b, bool is_graze);

}  // namespace graze::compare
