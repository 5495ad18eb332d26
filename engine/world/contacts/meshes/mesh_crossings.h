#pragma once

// Where the triangles of two meshes go through each other, in plain doubles. Private to
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
  narrowphase::Vec3 from;  ///< `to` lies from here along normal_a x normal_b
  narrowphase::Vec3 to;
  narrowphase::Vec3 normal_a;  ///< unit
  narrowphase::Vec3 normal_b;
  std::uint32_t piece;  ///< crossings that share triangles, or do through others, are of one piece
  std::uint32_t loop;   ///< within its piece: closed curves have their own, open ones share one
  std::uint32_t from_number = 0;  ///< equal points of a piece have one number
  std::uint32_t to_number = 0;
};

/// Where an edge goes through a triangle of the other mesh.
struct EdgeCrossing {
  std::uint32_t low;  ///< welded vertices
  std::uint32_t high;
  double share;  ///< of the edge, from low to high
  std::uint32_t loop;
  bool is_entry;  ///< from low to high it goes behind the triangle
};

/// Kept from one pair to the next, so that no step of a simulation allocates.
struct MeshCrossings {
  std::vector<TrianglePair> pairs;  ///< all that share a point, exactly
  std::vector<MeshCrossing> crossings;
  std::vector<EdgeCrossing> edges_a;  ///< ascending by edge and then along it
  std::vector<EdgeCrossing> edges_b;
  std::uint32_t pieces = 0;
  std::uint32_t loops = 0;
  std::vector<std::uint32_t> parent;
  std::vector<std::uint32_t> order;
  std::vector<std::uint8_t> met_ends;
};

/// Points are relative to the origin. The crossings leave out pairs that touch in one plane or in a
/// point, to rounding; the answer is whether these are the fewer ones, so that what was found
/// stands for all.
bool find_crossings(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                    const narrowphase::Vec3& origin, MeshCrossings& found, Work& work);

}  // namespace graze
