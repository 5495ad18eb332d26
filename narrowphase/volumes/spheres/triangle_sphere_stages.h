#pragma once

#include <graze/narrowphase/predicates/verdict.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>

// The stages of intersects() for a triangle and a ball, and what casts ask beside them.

namespace graze::narrowphase {

/// Returns what intersects() answers, with the stage that decided. Throws as intersects() does.
Decision decide(const Triangle& triangle, const Sphere& sphere);

/// Asks the floating-point stage alone. Input that is not finite, or a negative radius, is Unsure.
Verdict triage(const Triangle& triangle, const Sphere& sphere);

/// Asks the exact stage alone. Throws as intersects() does.
bool intersects_exactly(const Triangle& triangle, const Sphere& sphere);

/// True only if the sphere, moved by t d, is apart from the triangle at all t from 0 to `until`,
/// which is not negative: one plane separates the triangle from where the sphere is at either end.
/// Asks the floating-point stage alone; false for input that is not finite.
bool is_surely_passed(const Triangle& triangle, const Sphere& sphere, const Eigen::Vector3d& d,
                      double until);

/// True only if the sphere, moved by t d, meets the triangle at t = `at`, which is not negative.
/// Asks the floating-point stage alone; false for input that is not finite.
bool is_surely_met(const Triangle& triangle, const Sphere& sphere, const Eigen::Vector3d& d,
                   double at);

}  // namespace graze::narrowphase
