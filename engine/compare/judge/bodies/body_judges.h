#pragma once

#include <graze/engine/cases/case.h>
#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/judge/meshes/parts_review.h>
#include <graze/engine/compare/judge/shape_judge.h>

#include <optional>
#include <vector>

namespace graze::compare {

/// The contacts of two bodies that hit, as find_contacts() of shapes promises them. Of two convex
/// bodies a plane across the common normal must part them once B is moved by the greatest depth,
/// and not much sooner; that depth is the least of all directions, by least_parting(), whose bounds
/// the truth gets; and points lie midway between the surfaces. Of meshes and height fields the
/// normals and depths are not judged.
PartsReview review_manifold(const PlacedBody& a, const PlacedBody& b,
                            const std::vector<CaseShapeContact>& contacts, std::string& truth);

/// The same of another engine, which promises less: any number of contacts in any order, each with
/// a unit normal and a point as near to both as it is deep. Moved by the depth of the deepest along
/// its normal B is apart from A, and the depth is no more than what lets a plane across the normal
/// part them, and the least of all directions: what is longer is ErrorClass::NotLeast. All to
/// kOthersTolerance of the smaller size, as engines compute partly in float.
PartsReview review_others_contacts(const PlacedBody& a, const PlacedBody& b,
                                   const std::vector<CaseShapeContact>& contacts,
                                   std::string& truth);

/// The distance of two bodies: two balls, or a mesh and a mesh or a ball, exactly; else by proof.
/// The points are on the surfaces and so far apart: no less is claimed than is true. A plane across
/// the normal, or across the segment between the points, has the two so far on different sides: no
/// more is claimed. Of a number alone the library proposes both, and the words have both bounds.
/// Where that proves nothing, as of a mesh and what is not flat, the distance from below is not
/// judged. A negative one of another engine claims a touch: how deep is right to say of two convex
/// shapes, to parting_tolerance(); -1 is right of all, and no other depth is judged.
PartsReview review_distance(const PlacedBody& a, const PlacedBody& b, const CaseAnswer& answer,
                            bool is_graze);

/// Whether two bodies are within a clearance, by a plane that has them further apart, or two points
/// that are as near: neither, not judged. Whether they meet is known before, if it is. graze is
/// right to call within what is further by distance_tolerance() alone, as law 11 has it.
Judgement judge_within(const PlacedBody& a, const PlacedBody& b, std::optional<bool> is_hit,
                       const Case& query, bool says, bool is_graze);

/// A translation of B that parts two convex bodies: as long as is said, none of two that are apart,
/// not longer than a plane across it asks for; after it the two are apart, and no shorter one does,
/// both by least_parting(). Of two boxes a twentieth more is granted. Of meshes and height fields
/// the referee says that they are apart after it, and it is no longer than what parts their hulls;
/// that a shorter one does is not judged. Whether they meet is known before, if it is. All to
/// parting_tolerance().
Judgement judge_separation(const PlacedBody& a, const PlacedBody& b, std::optional<bool> is_hit,
                           const CaseAnswer& answer, bool is_graze);

/// A ray at a body that is no mesh. How far a point is outside of a convex shape is a convex
/// function along the ray: its least value, found by dividing the interval, says whether the ray
/// goes in, and the hit is where it first falls to zero. All to 2^-38 of the scale, four times what
/// cast_ray() grants itself; a ray that comes nearer to the surface than that is not judged.
Judgement judge_body_ray(const CaseBody& body, const Ray& ray, const CaseAnswer& answer);

/// A ray at a mesh or a triangle, the first hit or all of them, in rational numbers: which
/// triangles are met, how far away, in which point and with which normal. The bounds are those that
/// cast_ray() promises, for other engines kTouchUlps. A hit as far as the ray reaches, but for
/// these, may be told either way.
Judgement judge_surface_ray(const Case& query, const CaseAnswer& answer, bool is_graze);

}  // namespace graze::compare
