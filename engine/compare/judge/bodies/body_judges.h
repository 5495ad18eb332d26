#pragma once

#include <graze/engine/cases/case.h>
#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/judge/meshes/parts_review.h>
#include <graze/engine/compare/judge/shape_judge.h>

#include <optional>
#include <vector>

namespace graze::compare {

/// Reviews the contacts of two bodies that hit, as find_contacts() of shapes promises them. For two
/// convex bodies a plane across the common normal must part them once B is moved by the greatest
/// depth, and not much sooner; that depth is the least of all directions, by least_parting(), whose
/// bounds the truth gets; and points lie midway between the surfaces. The normals and depths of
/// meshes and height fields are not judged.
PartsReview review_manifold(const PlacedBody& a, const PlacedBody& b,
                            const std::vector<CaseShapeContact>& contacts, std::string& truth);

/// Reviews the contacts of another engine, which promises less: any number of contacts in any
/// order, each with a unit normal and a point as near to both as it is deep. Moved by the depth of
/// the deepest along its normal B is apart from A, and the depth is no more than what lets a plane
/// across the normal part them, and the least of all directions: a longer one is
/// ErrorClass::NotLeast. All is judged to kOthersTolerance of the smaller size, as engines compute
/// partly in float.
PartsReview review_others_contacts(const PlacedBody& a, const PlacedBody& b,
                                   const std::vector<CaseShapeContact>& contacts,
                                   std::string& truth);

/// Reviews the distance of two bodies: exactly that of two balls, or of a mesh and a mesh or a
/// ball, and else by proof. If the points are on the surfaces and so far apart, no less is claimed
/// than is true. If a plane across the normal, or across the segment between the points, has the
/// two so far on different sides, no more is claimed. For a number alone the library proposes both,
/// and the words have both bounds. Where that proves nothing, as for a mesh and a shape that is not
/// flat, the distance from below is not judged. A negative distance of another engine claims a
/// touch. For two convex shapes it is right to say how deep, to parting_tolerance(); for all shapes
/// -1 is right, and no other depth is judged.
PartsReview review_distance(const PlacedBody& a, const PlacedBody& b, const CaseAnswer& answer,
                            bool is_graze);

/// Judges whether two bodies are within a clearance, by a plane that has them further apart, or two
/// points that are as near. Without either it is not judged. Whether they meet is known before, if
/// it is known at all. graze is right to say so of bodies that are further apart by
/// distance_tolerance() alone, as law 11 has it.
Judgement judge_within(const PlacedBody& a, const PlacedBody& b, std::optional<bool> is_hit,
                       const Case& query, bool says, bool is_graze);

/// Judges a translation of B that parts two convex bodies. It must be as long as is said, zero for
/// two that are apart, and not longer than a plane across it asks for; after it the two must be
/// apart, and no shorter one may part them, both by least_parting(). Two boxes are granted a
/// twentieth more. For meshes and height fields the referee says whether they are apart after it,
/// and it may be no longer than what parts their hulls; whether a shorter one does is not judged.
/// Whether they meet is known before, if it is known at all. All is judged to parting_tolerance().
Judgement judge_separation(const PlacedBody& a, const PlacedBody& b, std::optional<bool> is_hit,
                           const CaseAnswer& answer, bool is_graze);

/// Judges a ray at a body that is no mesh. How far a point is outside of a convex shape is a convex
/// function along the ray: its least value, found by dividing the interval, says whether the ray
/// goes in, and the hit is where it first falls to zero. All is judged to 2^-38 of the scale, four
/// times what cast_ray() grants itself; a ray that comes nearer to the surface than that is not
/// judged.
Judgement judge_body_ray(const CaseBody& body, const Ray& ray, const CaseAnswer& answer);

/// Judges a ray at a mesh or a triangle, the first hit or all of them, in rational numbers: which
/// triangles are met, how far away, in which point and with which normal. The bounds are those that
/// cast_ray() promises, for other engines kTouchUlps. A hit that is within these bounds of the
/// ray's end may be told or not.
Judgement judge_surface_ray(const Case& query, const CaseAnswer& answer, bool is_graze);

}  // namespace graze::compare
