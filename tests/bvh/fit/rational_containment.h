#pragma once

// Whether volumes contain points, decided in rational arithmetic on the volumes' own doubles.

#include <graze/bvh/aabb.h>
#include <graze/bvh/kdop.h>
#include <graze/bvh/obb.h>
#include <graze/bvh/sphere.h>

#include <gmpxx.h>
#include <array>

namespace graze::tests {

using RationalPoint = std::array<mpq_class, 3>;

RationalPoint to_rational(const Eigen::Vector3d& point);

bool contains(const Aabb& box, const RationalPoint& point);
bool contains(const Sphere& sphere, const RationalPoint& point);
bool contains(const KDop<18>& kdop, const RationalPoint& point);

/// The reading p = t + R y with y in [-h, h].
bool contains(const Obb& box, const RationalPoint& point);

/// Law 3's reading: the coordinates that it rounds are in [-h, h].
bool contains_by_law_3(const Obb& box, const Eigen::Vector3d& point);

/// p = t + R y, exactly.
RationalPoint corner(const Obb& box, const std::array<int, 3>& signs);

}  // namespace graze::tests
