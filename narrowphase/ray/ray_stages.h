#pragma once

// Casts a ray at a triangle in two stages: signs decide whether they meet, then values say where.
//
// With w = a - o, n = (b - a) x (c - a), ray points are o + s d. The line through the ray passes
// the edge p q on the side that the sign of ((p - o) x (q - o)) . d says; the three add up to n .
// d. It goes through the triangle, and not along it, if none of them is against the others and not
// all are zero; there s = (n . w) / (n . d). Neighbours compute the sign of their common edge with
// p and q swapped, which is exactly the opposite: nothing slips through between them.

#include <graze/bvh/value/ray_slabs.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/predicates/verdict.h>
#include <graze/narrowphase/triangle_ray.h>

namespace graze::narrowphase {

/// A ray that has been checked, with what all triangles need to know of it. The ray must outlive
/// it.
struct PreparedRay {
  explicit PreparedRay(const Ray& checked)
      : ray(checked), scaled(bvh::scaled_direction(checked.direction.data())) {}

  const Ray& ray;
  bvh::ScaledDirection scaled;
};

/// Returns what cast_ray() answers for a triangle that is finite. `stage` becomes the stage that
/// decided whether the two meet.
std::optional<TriangleRayHit> cast_ray(const Triangle& triangle, const PreparedRay& ray,
                                       Stage& stage);

/// Does the same for a triangle of these corners that the ray is known to go through, within it and
/// not along it, ahead of its origin. Returns nothing where the ray ends before the triangle, and
/// where cast_ray() has to say, which is seldom.
std::optional<TriangleRayHit> cast_through(const double* a, const double* b, const double* c,
                                           const PreparedRay& ray);

/// Says where the ray is in the triangle first, or would be if there were no largest distance.
struct RayPlace {
  double scale;  ///< a multiple of the scaled direction: the point is origin + scale * component
  Eigen::Vector3d point;
};

/// Returns the place at that scale, rounded.
inline RayPlace point_at(double scale, const PreparedRay& ray) {
  const double *o = ray.ray.origin.data(), *d = ray.scaled.component;
  return {scale, {o[0] + scale * d[0], o[1] + scale * d[1], o[2] + scale * d[2]}};
}

/// Returns where a ray meets a triangle that it goes through by the signs above.
RayPlace place_on_face(const Triangle& triangle, const PreparedRay& ray);

/// Does the same for a ray whose line passes all three edges with sign zero: it and the triangle
/// lie in one plane, or the triangle has no area. Decides in integers whether they meet at all.
std::optional<RayPlace> place_in_plane(const Triangle& triangle, const PreparedRay& ray);

/// Returns the unit normal of a triangle with area, on the side where its corners turn
/// counter-clockwise.
Eigen::Vector3d unit_normal(const Triangle& triangle);

}  // namespace graze::narrowphase
