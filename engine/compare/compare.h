#pragma once

// Asks two engines one question, and a referee where they do not agree.

#include <graze/engine/compare/fcl_engine.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placed_mesh.h>

#include <cstddef>
#include <span>
#include <vector>

namespace graze::compare {

/// Describes a pair that decides: one engine says that it intersects, the other does not, and the
/// referee knows. For boolean queries "says" is the answer for the whole meshes.
struct Difference {
  TrianglePair pair;
  bool graze_says;
  bool fcl_says;
  bool truth;
};

/// Holds what both engines answered to one query, and who was right where they differ. Where they
/// agree nothing is settled.
struct Comparison {
  bool graze_intersects = false;
  bool fcl_intersects = false;
  std::size_t graze_pairs = 0;  ///< 0 for boolean queries
  std::size_t fcl_pairs = 0;    ///< 0 for boolean queries
  std::vector<Difference> differences;
  std::size_t graze_wrong = 0;  ///< answers of graze that the referee overrules
  std::size_t fcl_wrong = 0;    ///< answers of FCL that the referee overrules
};

/// Holds one side of a query, as both engines have it. Both must outlive it.
struct Side {
  PlacedMeshView placed;
  const FclMesh& fcl;
};

/// Compares lists of pairs that are already there, both ascending and without duplicates: each pair
/// in one of them only is settled by the referee for the placed triangles (laws 1 and 2).
Comparison compare_pairs(std::span<const TrianglePair> graze_pairs,
                         std::span<const TrianglePair> fcl_pairs, const PlacedMeshView& mesh_a,
                         const PlacedMeshView& mesh_b);

/// Runs find_triangle_pairs() of both engines and compares the lists.
Comparison compare_pairs(const Side& side_a, const Side& side_b);

/// Compares boolean answers that are already there. If they differ, `witnesses` holds all pairs of
/// the engine that says yes. The referee looks for one that intersects: the first, if any, decides
/// that "no" was wrong, and if there is none, nothing supports the "yes", which counts as wrong.
Comparison compare_any(bool graze_intersects, bool fcl_intersects,
                       std::span<const TrianglePair> witnesses, const PlacedMeshView& mesh_a,
                       const PlacedMeshView& mesh_b);

/// Runs intersects() of both engines, and where they differ finds the pairs of the one that says
/// yes.
Comparison compare_any(const Side& side_a, const Side& side_b);

/// Compares boolean answers in the same way, with graze's answer already there.
Comparison compare_any(bool graze_intersects, const Side& side_a, const Side& side_b);

}  // namespace graze::compare
