#pragma once

#include <graze/narrowphase/convex/core/core.h>

namespace graze::narrowphase {

struct NearestPoints {
  Vec3 point_a;
  Vec3 point_b;
};

/// Returns the point of the segment from `p` to `q` nearest to `point`; degenerate segments are
/// points.
Vec3 nearest_on_segment(const Vec3& p, const Vec3& q, const Vec3& point);

/// Returns the nearest points of two segments, and one pair of them if the segments are parallel:
/// the best of the inner point of both lines and of each end against the other segment. Their
/// distance is the least but for rounding, at any angle: closed_gap.cpp adds it up. Lumelsky, "On
/// fast computation of distance between line segments" (1985).
NearestPoints nearest_of_segments(const Vec3& p_a, const Vec3& q_a, const Vec3& p_b,
                                  const Vec3& q_b);

/// Returns the point of a triangle core nearest to a point. Ericson, "Real-Time Collision
/// Detection" (2005), 5.1.5.
Vec3 nearest_on_triangle(const Core& triangle, const Vec3& point);

/// True if a triangle is so narrow that its plane is worse known than its corners: its height is
/// less than about 2^-8 of its length.
bool is_narrow(const Core& triangle);

}  // namespace graze::narrowphase
