#pragma once

#include <graze/engine/work.h>
#include <graze/engine/world/placed_shape.h>
#include <Eigen/Core>

#include <optional>

namespace graze {

/// The first contact of a shape that moves along a straight line with another one.
struct ShapeCast {
  double time;             ///< the time, in [0, 1], never later than the first contact
  bool is_at_start;        ///< true if intersects() is true at t = 0
  Eigen::Vector3d point;   ///< the place where they meet, metres, on A, which rests
  Eigen::Vector3d normal;  ///< a unit vector from A to B

  bool operator==(const ShapeCast&) const = default;
};

/// Returns when shape B, placed once and then moved by `t displacement` (metres in the world's
/// frame, t in [0, 1]), meets A first, or nothing if it never does (law 13). Either shape may be a
/// mesh.
///
/// The answer for a mesh with a mesh, a sphere or a box is exact: that of mesh_cast.h or
/// volume_cast.h, with its points and normals. For all other pairs only two things are sure:
/// "nothing", and that the two are apart at all times below `time`, in real arithmetic on the
/// placed shapes. At `time` the lower bound of their distance is at most kTouchTolerance of twice
/// the scale of the pair at t = 0 and the length of the displacement. So shapes that pass each
/// other nearer than that may count as met. A search that does not end counts as met, too, at the
/// time that is proved by then, and in Work::convex_failures. A shape that moves along another or
/// away from it does not count as met if it is further from it than 2^-45 of the scale. For a
/// half-space, whose scale has the coordinates of both, one support point gives the time.
///
/// Shapes that intersect at t = 0 by intersects() meet at time 0: then the point and the normal are
/// those of the deepest contact (find_contacts()), or of the exact cast. Otherwise the normal is
/// that of the planes which part the two last, and the point, on A, is known to the tolerance.
///
/// Swapping A and B along the opposite displacement gives the same time, and the opposite normal.
/// It costs O(log n) for compact meshes, and some microseconds for two convex shapes. Throws
/// InputError for a displacement that is not finite, and PoseError for a pose that is refused by
/// law 10 or a displacement that moves a shape beyond kLargestLength.
///
/// Each step of the search goes as far as the gap lasts along its normal: conservative advancement
/// (Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems, 1996), which for translations
/// is Newton's method on a convex gap (van den Bergen, "Ray casting against general convex objects
/// with application to continuous collision detection", 2004).
///
/// The function is a template with one instance for the reason given in shape_pairs.h.
template <typename = void>
std::optional<ShapeCast> cast(const PlacedShapeView& shape_a, const PlacedShapeView& shape_b,
                              const Eigen::Vector3d& displacement, Work* work = nullptr);

}  // namespace graze
