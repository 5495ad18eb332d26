#pragma once

#include <functional>

#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>
#include <graze/engine/mesh/placed_mesh.h>

namespace graze::compare {

/// How wrong it is to say the opposite of the truth about one pair of triangles, and why.
struct PairError {
  ErrorClass error_class;
  double error;  ///< metres
  double ulps;
};

/// The one rule for the class of an error that two placed triangles show best, whatever was asked.
/// One of the two has no area: Degenerate. Else, up to kTouchUlps, the first that fits: one plane
/// holds both (Coplanar), placing has made it (PoseRounding), Touching. And beyond that: one mesh
/// lies inside the other (Containment), or Real. What may take time is asked only where it decides;
/// an empty function says no.
ErrorClass class_of_pair(const RationalTriangle& a, const RationalTriangle& b, double ulps,
                         const std::function<bool()>& is_due_to_placing,
                         const std::function<bool()>& is_containment);

/// Whether placing may have changed the answer: it is another where the poses are real numbers, or
/// where one of the two is brought into the other's frame in double, as engines do that make one
/// pose of two. Nobody is asked, so that one answer has one class, whoever gave it and wherever it
/// stands.
bool is_due_to_placing(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                       const TrianglePair& pair, bool is_hit);

/// `is_containment` as of class_of_pair().
PairError pair_error(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                     const TrianglePair& pair, bool is_hit,
                     const std::function<bool()>& is_containment = {});

/// Whether two meshes that hit do not in one of these ways of placing them.
bool is_hit_by_placing(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b);

/// The distance from the largest absolute coordinate of both to the next double.
double ulp_of(const Triangle& triangle_a, const Triangle& triangle_b);

}  // namespace graze::compare
