// A box and its surface are both connected, so the distances of their points from the centre are
// all those from the smallest to the largest. A ball meets such a set if its radius is at least the
// smallest, a sphere's surface if its radius lies between the two. The farthest point is a corner,
// hollow or not; the nearest is that of the solid box while the centre is outside, and on the
// nearest face otherwise.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/narrowphase/predicates/exact_vector.h>
#include <graze/narrowphase/volumes/hollow_overlap.h>
#include <graze/narrowphase/volumes/spheres/sphere_distance.h>
#include <graze/narrowphase/volumes/spheres/sphere_stages.h>
#include <algorithm>
#include <cmath>

namespace graze {
namespace narrowphase {
namespace {

bool has_centre_inside(const Sphere& sphere, const Aabb& box) {
  bool is_inside = true;
  for (int i = 0; i < 3; ++i) {
    const double c = sphere.centre.data()[i];
    is_inside &= box.min.data()[i] <= c && c <= box.max.data()[i];
  }
  return is_inside;
}

/// Returns the sign of (high - low) - radius: rounding is monotone, so that the rounded difference
/// is on the side of the exact one, or equal to the radius.
std::optional<Sign> sign_of_depth(double low, double high, double radius) {
  const double depth = high - low;
  if (depth == radius) return std::nullopt;
  return depth > radius ? Sign::Positive : Sign::Negative;
}

Sign sign_of_depth_exact(double low, double high, double radius) {
  const CommonUnit unit({low, high, radius});
  return (unit(high, low) - unit.of(radius)).sign();
}

/// Each function returns the sign of the distance from the centre minus the radius. `near_*` are
/// about the nearest point of the solid box, `surface_*` about that of its surface, `far_*` about
/// the farthest point.
std::optional<Sign> near_sign(const Sphere& sphere, const Aabb& box) {
  const double* c = sphere.centre.data();
  return sign_of_distance(c, nearest_point(box, c).data(), sphere.radius);
}

Sign near_sign_exact(const Sphere& sphere, const Aabb& box) {
  const double* c = sphere.centre.data();
  return sign_of_distance_exact(c, nearest_point(box, c).data(), sphere.radius);
}

std::optional<Sign> surface_sign(const Sphere& sphere, const Aabb& box) {
  if (!has_centre_inside(sphere, box)) return near_sign(sphere, box);
  bool is_sure = true;
  for (int i = 0; i < 3; ++i) {
    const double c = sphere.centre.data()[i];
    const std::optional<Sign> low = sign_of_depth(box.min.data()[i], c, sphere.radius);
    const std::optional<Sign> high = sign_of_depth(c, box.max.data()[i], sphere.radius);
    if (low == Sign::Negative || high == Sign::Negative) return Sign::Negative;
    is_sure &= low.has_value() && high.has_value();
  }
  if (!is_sure) return std::nullopt;
  return Sign::Positive;
}

Sign surface_sign_exact(const Sphere& sphere, const Aabb& box) {
  if (!has_centre_inside(sphere, box)) return near_sign_exact(sphere, box);
  Sign least = Sign::Positive;
  for (int i = 0; i < 3; ++i) {
    const double c = sphere.centre.data()[i];
    least = std::min(least, sign_of_depth_exact(box.min.data()[i], c, sphere.radius));
    least = std::min(least, sign_of_depth_exact(c, box.max.data()[i], sphere.radius));
  }
  return least;
}

/// Returns the sign for the farthest corner. The larger of two rounded offsets is the larger one,
/// rounded.
std::optional<Sign> far_sign(const Sphere& sphere, const Aabb& box) {
  double offset[3];
  for (int i = 0; i < 3; ++i) {
    const double c = sphere.centre.data()[i];
    offset[i] = std::max(std::abs(c - box.min.data()[i]), std::abs(box.max.data()[i] - c));
  }
  return sign_of_offset(offset, sphere.radius);
}

Sign far_sign_exact(const Sphere& sphere, const Aabb& box) {
  CommonUnit unit({sphere.radius});
  unit.include(sphere.centre.data(), 3);
  unit.include(box.min.data(), 3);
  unit.include(box.max.data(), 3);
  BigInteger distance2;
  for (int i = 0; i < 3; ++i) {
    const double c = sphere.centre.data()[i];
    const BigInteger low2 = squared(unit(c, box.min.data()[i]));
    const BigInteger high2 = squared(unit(c, box.max.data()[i]));
    distance2 = distance2 + ((low2 - high2).sign() == Sign::Positive ? low2 : high2);
  }
  return (distance2 - squared(unit.of(sphere.radius))).sign();
}

}  // namespace

Decision decide(const Sphere& sphere, const HollowAabb& hollow) {
  const std::optional<Sign> sure = surface_sign(sphere, hollow.box);
  if (sure) return {*sure == Sign::Negative, Stage::Triage};
  return {surface_sign_exact(sphere, hollow.box) != Sign::Positive, Stage::Exact};
}

Decision decide(const HollowSphere& hollow, const Aabb& box) {
  const std::optional<Sign> near = near_sign(hollow.sphere, box);
  const std::optional<Sign> far = far_sign(hollow.sphere, box);
  if (near == Sign::Positive || far == Sign::Negative) return {false, Stage::Triage};
  if (near && far) return {true, Stage::Triage};
  const bool is_hit = near_sign_exact(hollow.sphere, box) != Sign::Positive &&
                      far_sign_exact(hollow.sphere, box) != Sign::Negative;
  return {is_hit, Stage::Exact};
}

Decision decide(const HollowSphere& hollow, const HollowAabb& hollow_box) {
  const Aabb& box = hollow_box.box;
  const std::optional<Sign> near = surface_sign(hollow.sphere, box);
  const std::optional<Sign> far = far_sign(hollow.sphere, box);
  if (near == Sign::Positive || far == Sign::Negative) return {false, Stage::Triage};
  if (near && far) return {true, Stage::Triage};
  const bool is_hit = surface_sign_exact(hollow.sphere, box) != Sign::Positive &&
                      far_sign_exact(hollow.sphere, box) != Sign::Negative;
  return {is_hit, Stage::Exact};
}

}  // namespace narrowphase

bool intersects(const Sphere& sphere, const HollowAabb& box) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    bvh::check_sphere(sphere, "sphere");
    bvh::check_box(box.box, "box");
    return narrowphase::decide(sphere, box).is_hit;
  });
}

bool intersects(const HollowAabb& box, const Sphere& sphere) {
  return intersects(sphere, box);
}

bool intersects(const HollowSphere& sphere, const Aabb& box) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    bvh::check_sphere(sphere.sphere, "sphere");
    bvh::check_box(box, "box");
    return narrowphase::decide(sphere, box).is_hit;
  });
}

bool intersects(const Aabb& box, const HollowSphere& sphere) {
  return intersects(sphere, box);
}

bool intersects(const HollowSphere& sphere, const HollowAabb& box) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    bvh::check_sphere(sphere.sphere, "sphere");
    bvh::check_box(box.box, "box");
    return narrowphase::decide(sphere, box).is_hit;
  });
}

bool intersects(const HollowAabb& box, const HollowSphere& sphere) {
  return intersects(sphere, box);
}

}  // namespace graze
