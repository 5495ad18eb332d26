#pragma once

#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/triangle_pairs.h>
#include <graze/engine/work.h>
#include <graze/narrowphase/first_contact.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace graze {

/// A mesh in one step of a simulation: its vertices move straight, the triangles between them stay.
/// Immutable; a copy is a handle to the same data. Safe to use from many threads at once.
class MeshPath {
 public:
  /// From where the vertices of `start` are to where those of `end` are, which is
  /// `start.deformed(...)`, or another mesh of the same triangles. Builds a tree over the boxes
  /// that triangles sweep: O(n log n), on all threads. Throws MeshError for meshes that differ in
  /// their number of vertices or in a triangle.
  MeshPath(const Mesh& start, const Mesh& end);

  /// The mesh at t = 0.
  const Mesh& start() const;
  /// The mesh at t = 1.
  const Mesh& end() const;

  /// What the path holds beside both meshes.
  std::size_t bytes() const;

 private:
  friend struct MeshPathAccess;
  struct Data;
  std::shared_ptr<const Data> data_;
};

/// Which features of two triangles meet.
enum class MeetingFeatures {
  VertexFace,  ///< a vertex of A and the closed triangle of B
  FaceVertex,  ///< the triangle of A and a vertex of B
  EdgeEdge,    ///< two closed edges
  AtStart      ///< the triangles meet as they are at t = 0, no matter where
};

/// When two meshes in motion meet first, and where.
struct MeshFirstContact {
  double time;               ///< as FirstContact::time
  bool is_at_start;          ///< whether it is at t = 0 itself
  TrianglePair pair;         ///< triangles that have the features
  MeetingFeatures features;  ///< which meet
  std::uint32_t place_a;  ///< the corner of A's triangle, 0 to 2; of an edge the one it leaves, in
                          ///< the order of the triangle; 0 for a face
  std::uint32_t place_b;  ///< likewise of B's

  bool operator==(const MeshFirstContact&) const = default;
};

/// When the triangles of two meshes in motion meet first, or nothing if they never do (law 12):
/// exact, never late. Of contacts of one time that of the lowest pair of triangles, then of the
/// first kind of features, then of the lowest places: so the largest step that is free is to
/// `time`, or to 1; with a separation the largest that keeps it. With StartContact::IsLeft each
/// vertex with each face and each pair of edges is asked so; triangles that cross at t = 0 meet
/// there all the same. Allocates for nothing but pairs of features that come near a separation.
std::optional<MeshFirstContact> first_contact(const MeshPath& path_a, const MeshPath& path_b,
                                              const FirstContactSettings& settings = {},
                                              Work* work = nullptr);

/// Of a mesh with itself, likewise, for a pair of triangles a < b. A vertex does not meet a
/// triangle of its own, nor an edge one that it has a vertex in common with, and triangles with a
/// common vertex are a hit at t = 0 only where they cross. With a separation that is above the
/// lengths of edges, most vertices are near neighbours of their own triangles at t = 0.
std::optional<MeshFirstContact> first_self_contact(const MeshPath& path,
                                                   const FirstContactSettings& settings = {},
                                                   Work* work = nullptr);

/// All contacts in a step: of each pair of features that meet when they first do, and of triangles
/// that cross at t = 0 that they do. Ascending by pairs of triangles, then kinds of features, then
/// places; a pair of features stands once, with the lowest triangles that have it.
std::vector<MeshFirstContact> find_contacts_in_step(const MeshPath& path_a, const MeshPath& path_b,
                                                    const FirstContactSettings& settings = {},
                                                    Work* work = nullptr);

/// Likewise of a mesh with itself, as first_self_contact() takes it.
std::vector<MeshFirstContact> find_self_contacts_in_step(const MeshPath& path,
                                                         const FirstContactSettings& settings = {},
                                                         Work* work = nullptr);

}  // namespace graze
