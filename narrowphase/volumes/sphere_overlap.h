#pragma once

#include <graze/bvh/sphere.h>
#include <Eigen/Core>

namespace graze {

/// True if and only if the closed balls share a point, in real arithmetic, on their doubles: the
/// squared distance of their centres is at most (r_a + r_b)^2. Throws InputError for a sphere that
/// is not finite or has a negative radius.
/// "Real-Time Rendering", 3rd ed., 16.13.1.
bool intersects(const Sphere& sphere_a, const Sphere& sphere_b);

/// True if and only if the point lies in the closed ball, in real arithmetic, on their doubles.
/// Throws InputError for a bad sphere or a point that is not finite.
bool contains(const Sphere& sphere, const Eigen::Vector3d& point);

}  // namespace graze
