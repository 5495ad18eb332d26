#pragma once

#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/mesh/placed_mesh.h>

namespace graze::compare {

/// How wrong it is to say the opposite of the truth about one pair of triangles, and why.
struct PairError {
  ErrorClass error_class;
  double error;  ///< metres
  double ulps;
};

PairError pair_error(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b, const TrianglePair& pair,
                     bool is_hit, const JudgeSettings& settings);

/// Whether two meshes that hit do not where the poses are real numbers and nothing is rounded.
bool is_hit_by_placing(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b);

/// The distance from the largest absolute coordinate of both to the next double.
double ulp_of(const Triangle& triangle_a, const Triangle& triangle_b);

}  // namespace graze::compare
