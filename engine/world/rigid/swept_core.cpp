#include <graze/engine/world/rigid/swept_core.h>

#include <algorithm>

namespace graze {

using narrowphase::Core;
using narrowphase::Vec3;

namespace {

struct LowHigh {
  double low, high;
};

LowHigh of_triangle(const Core& triangle, const Vec3& direction) {
  const double a = dot(triangle.corner[0], direction), b = dot(triangle.corner[1], direction),
               c = dot(triangle.corner[2], direction);
  return {std::min(a, std::min(b, c)), std::max(a, std::max(b, c))};
}

}  // namespace

SweptCore::SweptCore(const Core& core, const Vec3& displacement, double room)
    : core_(core), displacement_(displacement), room_(room) {
  const Vec3 along = unit_or(displacement, {0, 0, 1});
  const Vec3 first = any_normal_to(along), second = cross(along, first);
  across_[0] = first, across_[1] = second;
  across_[2] = unit_or(first + second, first), across_[3] = unit_or(first - second, first);
  for (int i = 0; i < kAcross; ++i)
    own_across_[i] = extent_along(across_[i]);
  take_normal(along);
}

void SweptCore::take_normal(const Vec3& normal) {
  normal_ = normal;
  own_normal_ = extent_along(normal);
}

SweptCore::Extent SweptCore::extent_along(const Vec3& unit) const {
  return {dot(rounded_support(core_, -unit), unit) - room_,
          dot(rounded_support(core_, unit), unit) + room_};
}

/// The gap changes linearly: if the set is on one side at both ends, it is there all the time.
bool SweptCore::is_passed_along(const Vec3& unit, const Extent& own, const Core& triangle,
                                double until) const {
  const LowHigh other = of_triangle(triangle, unit);
  const double moved = until * dot(displacement_, unit);
  return std::min(own.low, own.low + moved) > other.high ||
         std::max(own.high, own.high + moved) < other.low;
}

bool SweptCore::is_surely_passed(const Core& triangle, double until) const {
  for (int i = 0; i < kAcross; ++i) {
    if (is_passed_along(across_[i], own_across_[i], triangle, until)) return true;
  }
  if (is_passed_along(normal_, own_normal_, triangle, until)) return true;
  const Vec3 normal = unit_or(
      cross(triangle.corner[1] - triangle.corner[0], triangle.corner[2] - triangle.corner[0]),
      normal_);
  return is_passed_along(normal, extent_along(normal), triangle, until);
}

}  // namespace graze
