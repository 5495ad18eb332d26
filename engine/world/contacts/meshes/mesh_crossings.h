#pragma once

// Finds where the triangles of two meshes go through each other, in plain doubles. Private to
// engine/world.

#include <graze/engine/mesh/pair.h>
#include <graze/engine/work.h>
#include <graze/narrowphase/convex/core/vector.h>

#include <cstdint>
#include <span>
#include <vector>

namespace graze {

/// Two triangles and the segment in which they cross.
struct MeshCrossing {
  TrianglePair pair;
  narrowphase::Vec3 from;  ///< the end from which `to` lies along normal_a x normal_b
  narrowphase::Vec3 to;
  narrowphase::Vec3 normal_a;  ///< unit
  narrowphase::Vec3 normal_b;
  std::uint32_t piece;  ///< the piece: crossings that share triangles, or are connected by others,
                        ///< are of one piece
  std::uint32_t loop;   ///< the loop within its piece: closed curves have their own, open ones
                        ///< share one
  std::uint32_t from_number = 0;  ///< equal points of a piece have one number
  std::uint32_t to_number = 0;
};

/// A place where an edge goes through a triangle of the other mesh.
struct EdgeCrossing {
  std::uint32_t low;  ///< welded vertices
  std::uint32_t high;
  double share;  ///< the share of the edge, from low to high
  std::uint32_t loop;
  bool is_entry;  ///< whether from low to high it goes behind the triangle
};

/// The crossings of a pair. Memory is kept from one pair to the next, so that no step of a
/// simulation allocates.
struct MeshCrossings {
  std::vector<TrianglePair> pairs;  ///< all pairs of triangles that share a point, exactly
  std::vector<MeshCrossing> crossings;
  std::vector<EdgeCrossing> edges_a;  ///< ascending by edge and then along it
  std::vector<EdgeCrossing> edges_b;
  std::uint32_t pieces = 0;
  std::uint32_t loops = 0;
  std::vector<std::uint32_t> parent;
  std::vector<std::uint32_t> order;
  std::vector<std::uint8_t> met_ends;
};

/// Finds the crossings, with points relative to the origin. Pairs that touch in one plane or in a
/// point, up to rounding, are left out. True if these are the minority, so that the crossings stand
/// for all.
bool find_crossings(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                    const narrowphase::Vec3& origin, MeshCrossings& found, Work& work);

}  // namespace graze
