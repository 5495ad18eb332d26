#pragma once

#include <functional>

#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>
#include <graze/engine/mesh/placed_mesh.h>

namespace graze::compare {

/// Says how wrong it is to say the opposite of the truth about one pair of triangles, and why.
struct PairError {
  ErrorClass error_class;
  double error;  ///< metres
  double ulps;
};

/// Returns the class of an error that two placed triangles show best, by one rule, whatever was
/// asked. If one of the two has no area it is Degenerate. Else, up to kTouchUlps, it is the first
/// that fits: Coplanar if one plane holds both, PoseRounding if placing has made the error,
/// Touching. Beyond kTouchUlps it is Containment if one mesh lies inside the other, and else Real.
/// What may take time is asked only where it decides; an empty function says no.
ErrorClass class_of_pair(const RationalTriangle& a, const RationalTriangle& b, double ulps,
                         const std::function<bool()>& is_due_to_placing,
                         const std::function<bool()>& is_containment);

/// True if placing may have changed the answer: it is another one where the poses are real numbers,
/// or where one of the two is brought into the other's frame in double, as engines do that make one
/// pose of two. Nobody is asked, so that one answer has one class, whoever gave it and wherever it
/// stands.
bool is_due_to_placing(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                       const TrianglePair& pair, bool is_hit);

/// Returns the error; `is_containment` is that of class_of_pair().
PairError pair_error(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                     const TrianglePair& pair, bool is_hit,
                     const std::function<bool()>& is_containment = {});

/// True if two meshes that hit do not in one of these ways of placing them.
bool is_hit_by_placing(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b);

/// Returns the distance from the largest absolute coordinate of both to the next double.
double ulp_of(const Triangle& triangle_a, const Triangle& triangle_b);

}  // namespace graze::compare
