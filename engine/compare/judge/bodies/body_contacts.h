#pragma once

#include <vector>

#include <graze/engine/cases/case.h>
#include <graze/engine/compare/judge/meshes/parts_review.h>
#include <graze/engine/compare/judge/shape_judge.h>

namespace graze::compare {

/// The contacts of two bodies that hit, as find_contacts() of shapes promises them. Of two convex
/// bodies a plane across the common normal must part them once B is moved by the greatest depth,
/// and not much sooner; and points lie midway between the surfaces. Of meshes the normals and
/// depths are not judged.
PartsReview review_manifold(const PlacedBody& a, const PlacedBody& b,
                            const std::vector<CaseShapeContact>& contacts);

}  // namespace graze::compare
