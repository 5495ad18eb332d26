#pragma once

#include <graze/engine/cases/case.h>
#include <graze/engine/compare/judge/meshes/parts_review.h>
#include <graze/engine/compare/judge/shape_judge.h>

namespace graze::compare {

/// The distance of two bodies: two balls, or a mesh and a mesh or a ball, exactly; else by proof.
/// The points are on the surfaces and so far apart: no less is claimed than is true. A plane across
/// the normal, or across the segment between the points, has the two so far on different sides: no
/// more is claimed. Where that proves nothing, as of a mesh and what is not flat, the distance from
/// below is not judged.
PartsReview review_distance(const PlacedBody& a, const PlacedBody& b, const CaseAnswer& answer);

}  // namespace graze::compare
