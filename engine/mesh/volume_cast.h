#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/obb.h>
#include <graze/bvh/sphere.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/work.h>
#include <graze/narrowphase/cast.h>

#include <cstdint>
#include <optional>

namespace graze {

/// Says where something simple that goes straight meets a mesh first.
struct VolumeCast {
  double time;             ///< the time as FirstContact::time: in [0, 1], never late
  bool is_at_start;        ///< true if they meet at t = 0 itself
  std::uint32_t triangle;  ///< index of the mesh's triangle that is met
  Eigen::Vector3d point;   ///< the point on the mesh where they meet, metres
  Eigen::Vector3d normal;  ///< a unit vector, to a few ulp, from the mesh: against the displacement

  bool operator==(const VolumeCast&) const = default;
};

/// Returns when a closed solid box, moved by `t displacement` (metres, t in [0, 1]) in real
/// arithmetic, meets a placed mesh first, or nothing if it never does (law 13). The answer is exact
/// for all finite input, touching included. The time is the largest double that is not above the
/// contact; of triangles that are met at one time the lowest counts. To move the mesh instead, give
/// the opposite displacement: the time is the same.
///
/// The point and the normal are as for two meshes (mesh_cast.h), of which one is the triangle and
/// the other the two triangles of a face of the box; at t = 0 the point is a corner of the triangle
/// that is in the box, or one at which the triangle comes out of it.
///
/// It takes O(log n) for compact meshes, and allocates nothing once the tree is built. Throws
/// InputError for a displacement that is not finite and for an invalid box, PoseError as
/// intersects() does, and where coordinates are so large that sums of them could overflow.
std::optional<VolumeCast> cast(const PlacedMeshView& mesh, const Aabb& box,
                               const Eigen::Vector3d& displacement, Work* work = nullptr);

/// Returns the same for an oriented box, in its frame at t = 0: placed vertices go into it by law
/// 3, and so does the displacement, `(R_0i d_x + R_1i d_y) + R_2i d_z`, each operation rounded to
/// double. For the results of that the answer is exact; the point and the normal go back by the
/// box's pose, rounded, and as far as that is a rotation. Throws InputError also for a displacement
/// that overflows on its way.
std::optional<VolumeCast> cast(const PlacedMeshView& mesh, const Obb& box,
                               const Eigen::Vector3d& displacement, Work* work = nullptr);

/// Returns when a closed ball, moved by `t displacement` (metres, t in [0, 1]) in real arithmetic,
/// meets a placed mesh first, or nothing if it never does (law 13). The answer is exact for all
/// finite input, touching included, even if it lasts for no more than a moment that holds no
/// double. The time is the largest double that is not above the contact; of triangles that are met
/// at one time, which is decided exactly, the lowest counts. With StartContact::IsLeft a triangle
/// that the ball meets at t = 0 is left out unless the inside of the ball meets it then or directly
/// after: a ball that rests on triangles may leave them, or roll along them, until it comes to
/// others.
///
/// The point is the one of the triangle that is met, each coordinate off by at most 0.52 ulp of the
/// largest coordinate of the triangle; at t = 0 the one nearest to the centre. The normal leads
/// from there to the centre; where that is the point itself it is the triangle's, against the
/// displacement, or, moved within its plane, on either side. A ball without a radius is a point;
/// its normal is as for two meshes.
///
/// It takes O(log n) for compact meshes, and allocates nothing once the tree is built. Throws
/// InputError for a displacement that is not finite and for an invalid ball, PoseError as
/// intersects() does, and where coordinates are so large that sums of them could overflow.
std::optional<VolumeCast> cast(const PlacedMeshView& mesh, const Sphere& ball,
                               const Eigen::Vector3d& displacement,
                               const CastSettings& settings = {}, Work* work = nullptr);

}  // namespace graze
