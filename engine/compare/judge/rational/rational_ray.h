#pragma once

#include <optional>

#include <graze/bvh/ray.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>

namespace graze::compare {

/// A half line in rational numbers, without an end.
struct RationalRay {
  RationalPoint origin;
  RationalPoint direction;

  RationalPoint at(const mpq_class& s) const;
};

RationalRay exactly(const Ray& ray);

/// Returns the least s >= 0 at which the ray is in the closed triangle, and nothing if there is
/// none. A triangle whose plane holds the ray, or that has no area, is met at its sides or where
/// the ray begins.
std::optional<mpq_class> first_meeting(const RationalRay& ray, const RationalTriangle& triangle);

}  // namespace graze::compare
