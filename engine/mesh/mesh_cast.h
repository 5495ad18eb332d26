#pragma once

#include <graze/engine/mesh/mesh_path.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/narrowphase/cast.h>

namespace graze {

/// Says where a mesh that goes straight meets another one first.
struct MeshCast {
  double time;               ///< the time as FirstContact::time: in [0, 1], never late
  bool is_at_start;          ///< true if they meet at t = 0 itself
  TrianglePair pair;         ///< the triangles that meet at that time
  MeetingFeatures features;  ///< the features of these that meet; AtStart if it is at t = 0
  std::uint32_t place_a;     ///< the place of the feature of A, as in MeshFirstContact::place_a
  std::uint32_t place_b;     ///< the place of the feature of B
  Eigen::Vector3d point;     ///< the point on A, which stays, where they meet, metres
  Eigen::Vector3d normal;    ///< a unit vector, to a few ulp, from A to B: against the displacement

  bool operator==(const MeshCast&) const = default;
};

/// Returns when mesh B, placed once by law 1 and then moved by `t displacement` (metres in the
/// common frame, t in [0, 1]) in real arithmetic, meets A first, or nothing if it never does (law
/// 13). The answer is exact for all finite input, touching included. The time is the largest double
/// that is not above the contact. Of contacts of one time, which are compared exactly, that of the
/// lowest pair of triangles counts. If several features of these meet then, a corner of A and the
/// triangle of B come first, then the triangle of A and a corner of B, then two edges, each of the
/// lowest place. With StartContact::IsLeft a pair of triangles that meets at t = 0 is left out
/// unless it crosses there or directly after it: a body that rests on another one may leave it, or
/// slide along the triangles that it rests on, until it comes to others, and is met at t = 0 where
/// it would go in.
///
/// Placed anew where it has come to, B may be apart from A by intersects(), or go into it: law 1
/// rounds that place, by a few 2^-53 of the largest coordinates.
///
/// The point is that of the contact, not of the rounded time: off by at most 0.51 ulp in each
/// coordinate, at t = 0 as a corner of intersection() is. The normal is that of a triangle which a
/// corner meets, across both edges that meet, or across the edge which a corner meets, where the
/// triangle is along the displacement; at t = 0 it is that of A's triangle, of B's if A's has no
/// area, and zero where nothing has a direction. Only surfaces count: a mesh inside another one
/// does not meet it.
///
/// A cast takes O(log n) for compact meshes that are apart at t = 0, and else what
/// find_triangle_pairs() takes. Once all trees that it uses are built (prepare() with
/// PreparedFor::All builds them), a cast allocates nothing. Throws InputError for a displacement
/// that is not finite, PoseError as intersects() does, and where coordinates are so large that sums
/// of them could overflow.
std::optional<MeshCast> cast(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                             const Eigen::Vector3d& displacement, const CastSettings& settings = {},
                             Work* work = nullptr);

}  // namespace graze
