#include <graze/engine/compare/judge/rational/rational_triangle.h>
#include <graze/engine/compare/judge/rational/volume_error.h>
#include <graze/engine/compare/referee.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/box_frame.h>

#include <algorithm>

namespace graze::compare {
namespace {

mpq_class square(const mpq_class& x) {
  return x * x;
}

bool overlap(const Aabb& a, const Aabb& b) {
  return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

bool overlap(const Sphere& a, const Sphere& b) {
  mpq_class distance = 0;
  for (int axis = 0; axis < 3; ++axis)
    distance += square(mpq_class(a.centre[axis]) - mpq_class(b.centre[axis]));
  return distance <= square(mpq_class(a.radius) + mpq_class(b.radius));
}

bool overlap(const Sphere& sphere, const Aabb& box) {
  mpq_class distance = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double nearest = std::clamp(sphere.centre[axis], box.min[axis], box.max[axis]);
    distance += square(mpq_class(sphere.centre[axis]) - mpq_class(nearest));
  }
  return distance <= square(mpq_class(sphere.radius));
}

}  // namespace

bool referee_meets(const Triangle& triangle, const Aabb& box) {
  return referee_intersects(triangle, box);
}

bool referee_meets(const Triangle& triangle, const Obb& box) {
  return referee_intersects(narrowphase::into_frame(triangle, box.pose),
                            Aabb{-box.half_extents, box.half_extents});
}

bool referee_meets(const Triangle& t, const Sphere& sphere) {
  // Rounding is monotone: a difference above the radius was above it before it was rounded.
  for (int axis = 0; axis < 3; ++axis) {
    const double c = sphere.centre[axis];
    if (std::min({t.a[axis], t.b[axis], t.c[axis]}) - c > sphere.radius) return false;
    if (c - std::max({t.a[axis], t.b[axis], t.c[axis]}) > sphere.radius) return false;
  }
  const Triangle centre{sphere.centre, sphere.centre, sphere.centre};
  return squared_distance(exactly(t), exactly(centre)) <= square(mpq_class(sphere.radius));
}

std::optional<bool> referee_overlaps(const CaseShape& shape_a, const CaseShape& shape_b) {
  const auto* box_a = std::get_if<Aabb>(&shape_a);
  const auto* box_b = std::get_if<Aabb>(&shape_b);
  const auto* sphere_a = std::get_if<Sphere>(&shape_a);
  const auto* sphere_b = std::get_if<Sphere>(&shape_b);
  if (box_a != nullptr && box_b != nullptr) return overlap(*box_a, *box_b);
  if (sphere_a != nullptr && sphere_b != nullptr) return overlap(*sphere_a, *sphere_b);
  if (sphere_a != nullptr && box_b != nullptr) return overlap(*sphere_a, *box_b);
  if (sphere_b != nullptr && box_a != nullptr) return overlap(*sphere_b, *box_a);
  return std::nullopt;
}

}  // namespace graze::compare
