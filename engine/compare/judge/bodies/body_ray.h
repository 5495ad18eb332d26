#pragma once

#include <graze/engine/cases/case.h>
#include <graze/engine/compare/judge/judgement.h>

namespace graze::compare {

/// A ray at a body that is no mesh. How far a point is outside of a convex shape is a convex
/// function along the ray: its least value, found by dividing the interval, says whether the ray
/// goes in, and the hit is where it first falls to zero. All to 2^-38 of the scale, four times what
/// cast_ray() grants itself; a ray that comes nearer to the surface than that is not judged.
Judgement judge_body_ray(const CaseBody& body, const Ray& ray, const CaseAnswer& answer);

}  // namespace graze::compare
