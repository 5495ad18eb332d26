#pragma once

#include <graze/engine/work.h>
#include <graze/engine/world/placed_shape.h>
#include <Eigen/Core>

#include <optional>

namespace graze {

/// Where a shape that goes straight meets another one first.
struct ShapeCast {
  double time;             ///< in [0, 1]: never later than the first contact
  bool is_at_start;        ///< whether intersects() says yes at t = 0
  Eigen::Vector3d point;   ///< where they meet, metres, on A, which stays
  Eigen::Vector3d normal;  ///< a unit vector from A to B

  bool operator==(const ShapeCast&) const = default;
};

/// When shape B, placed once and then moved by `t displacement` (metres in the world's frame, t in
/// [0, 1]), meets A first, or nothing if it never does (law 13); a mesh, too, may be one of the
/// two.
///
/// Of a mesh with a mesh, a sphere or a box the answer is exact: that of mesh_cast.h and
/// volume_cast.h, with their points and normals. Of all others "nothing" alone is sure, and that
/// they are apart at all times below `time`, in real arithmetic on the placed shapes: at `time` the
/// lower bound of their distance is not above kTouchTolerance of twice the scale of the pair at t =
/// 0 and the length of the displacement. So shapes that pass each other nearer than
/// that may count as met, and a search that does not end does, at the time that is proved by then,
/// and in Work::convex_failures. What moves along what it nearly touches, or away from it, does
/// not, if it is further from it than 2^-45 of the scale. Beside a half-space, whose scale has the
/// coordinates of both, one support point tells the time.
///
/// What intersects() calls a hit at t = 0 is one: then the point and the normal are those of the
/// deepest contact (find_contacts()), or of the exact cast. Else the normal is that of the planes
/// which part the two last, and the point, on A, is known to the tolerance.
///
/// Swapping A and B along the opposite displacement gives the same time, and the opposite normal.
/// O(log n) for compact meshes, and some microseconds for two convex shapes. Throws InputError for
/// a displacement that is not finite, PoseError for a pose that is refused by law 10, and for what
/// moves a shape beyond kLargestLength.
///
/// Each step goes as far as the gap lasts along its normal: conservative advancement (Mirtich,
/// Impulse-based Dynamic Simulation of Rigid Body Systems, 1996), which for translations is
/// Newton's method on a convex gap (van den Bergen, "Ray casting against general convex objects
/// with application to continuous collision detection", 2004).
///
/// A template, of which there is one, for the reason given in shape_pairs.h.
template <typename = void>
std::optional<ShapeCast> cast(const PlacedShapeView& shape_a, const PlacedShapeView& shape_b,
                              const Eigen::Vector3d& displacement, Work* work = nullptr);

}  // namespace graze
