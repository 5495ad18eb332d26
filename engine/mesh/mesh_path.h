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
/// It is immutable; a copy is a handle to the same data. It may be used from many threads at once.
class MeshPath {
 public:
  /// Takes the vertices from where those of `start` are to where those of `end` are, which is
  /// `start.deformed(...)`, or another mesh of the same triangles. Builds a tree over the boxes
  /// that triangles sweep: O(n log n), on all threads. Throws MeshError for meshes that differ in
  /// their number of vertices or in a triangle.
  MeshPath(const Mesh& start, const Mesh& end);

  /// Returns the mesh at t = 0.
  const Mesh& start() const;
  /// Returns the mesh at t = 1.
  const Mesh& end() const;

  /// Returns how many bytes the path holds beside both meshes.
  std::size_t bytes() const;

 private:
  friend struct MeshPathAccess;
  struct Data;
  std::shared_ptr<const Data> data_;
};

/// The kinds of features of two triangles that meet.
enum class MeetingFeatures {
  VertexFace,  ///< a vertex of A and the closed triangle of B
  FaceVertex,  ///< the triangle of A and a vertex of B
  EdgeEdge,    ///< two closed edges
  AtStart      ///< the triangles meet as they are at t = 0, no matter where
};

/// Says when two meshes in motion meet first, and where.
struct MeshFirstContact {
  double time;               ///< the time as FirstContact::time
  bool is_at_start;          ///< true if they meet at t = 0 itself
  TrianglePair pair;         ///< the triangles that have the features
  MeetingFeatures features;  ///< the kinds of features that meet
  std::uint32_t place_a;  ///< the corner of A's triangle, 0 to 2; of an edge the one it leaves, in
                          ///< the order of the triangle; 0 for a face
  std::uint32_t place_b;  ///< the corner of B's triangle, likewise

  bool operator==(const MeshFirstContact&) const = default;
};

/// Returns when the triangles of two meshes in motion meet first, or nothing if they never do (law
/// 12). The time is exact, never late: so the largest step that is free is to `time`, or to 1; with
/// a clearance it is the largest that keeps it. Of contacts of one time that of the lowest pair of
/// triangles counts, then that of the first kind of features, then that of the lowest places. With
/// StartContact::IsLeft each vertex is asked so with each face, and each pair of edges; triangles
/// that cross at t = 0 meet there all the same. It allocates for nothing but pairs of features that
/// come near a clearance.
std::optional<MeshFirstContact> first_contact(const MeshPath& path_a, const MeshPath& path_b,
                                              const FirstContactSettings& settings = {},
                                              Work* work = nullptr);

/// Returns when a mesh in motion meets itself first, in the same way, with a pair of triangles a <
/// b. A vertex does not meet a triangle of its own, nor an edge one that it has a vertex in common
/// with, and triangles with a common vertex are a hit at t = 0 only where they cross. With a
/// clearance that is above the lengths of edges, most vertices are near neighbours of their own
/// triangles at t = 0.
std::optional<MeshFirstContact> first_self_contact(const MeshPath& path,
                                                   const FirstContactSettings& settings = {},
                                                   Work* work = nullptr);

/// Returns all contacts in a step: each pair of features that meet, with the time when they first
/// do, and triangles that cross at t = 0, with that time. The contacts ascend by pairs of
/// triangles, then kinds of features, then places; a pair of features stands once, with the lowest
/// triangles that have it.
std::vector<MeshFirstContact> find_contacts_in_step(const MeshPath& path_a, const MeshPath& path_b,
                                                    const FirstContactSettings& settings = {},
                                                    Work* work = nullptr);

/// Returns all contacts in a step of a mesh with itself, as first_self_contact() takes it.
std::vector<MeshFirstContact> find_self_contacts_in_step(const MeshPath& path,
                                                         const FirstContactSettings& settings = {},
                                                         Work* work = nullptr);

}  // namespace graze
