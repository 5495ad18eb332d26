#pragma once

// A convex set as the solvers of this folder see it: a core, placed, and a radius around it.

#include <graze/narrowphase/convex/core/vector.h>

#include <cstddef>

namespace graze::narrowphase {

struct Hull;
class PointRows;

enum class CoreKind { Point, Segment, Box, Cylinder, Cone, Ellipsoid, Points, Triangle };

/// The points of the set are those at most `radius` from the core. A sphere is a point with a
/// radius, a capsule a segment with one; all others have radius 0. So sets that touch with their
/// rounded parts are solved by the distance of their cores, which do not overlap there.
///
/// A core lives in a frame of its own: columns `axis[0..2]`, not quite orthonormal where a pose is
/// not, and the origin `at`. All placed cores of one query are in one frame with the world's
/// axes, whose origin lies near the two, so that precision follows their distance and their sizes,
/// not how far from the world's origin they are.
struct Core {
  CoreKind kind = CoreKind::Point;
  Vec3 axis[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Vec3 at;
  Vec3 half;  ///< Box: half extents. Ellipsoid: semi-axes. Segment: half length as z.
              ///< Cylinder, Cone: radius as x, half height as z; a cone's apex is at +z
  double radius = 0;
  double bounding_radius = 0;    ///< a bound of how far points of the core are from `at`
  const Hull* hull = nullptr;    ///< Points: the hull whose corners they are; nullptr if unknown
  const Vec3* points = nullptr;  ///< Points: the corners in the core's own frame
  std::size_t point_count = 0;
  const PointRows* rows = nullptr;  ///< Points: the same points and perhaps more, or nullptr
  Vec3 corner[3];  ///< Triangle: in the common frame; axes do not concern it, `at` is corner[0]
};

// These functions are static, as those of vector.h are.

/// Take a vector from the core's own frame to the common one, and back by the transpose.
static inline Vec3 turned(const Core& core, const Vec3& own) {
  return (core.axis[0] * own.x + core.axis[1] * own.y) + core.axis[2] * own.z;
}
static inline Vec3 into_own(const Core& core, const Vec3& direction) {
  return {dot(core.axis[0], direction), dot(core.axis[1], direction), dot(core.axis[2], direction)};
}

/// Returns a point of the core that is farthest in a direction, not zero. Ties go to the first of
/// the points, and to the positive side.
Vec3 support(const Core& core, const Vec3& direction);

/// Returns the same for the set, that is, with the radius.
Vec3 rounded_support(const Core& core, const Vec3& unit_direction);

/// Returns a bound of the sums that make up points of both sets, by which rounding is measured.
double pair_scale(const Core& a, const Core& b);

}  // namespace graze::narrowphase
