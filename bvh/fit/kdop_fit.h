#pragma once

#include <graze/bvh/kdop.h>
#include <Eigen/Core>
#include <span>

namespace graze {

/// Returns the smallest k-DOP around the points, in linear time. Each sum of coordinates is rounded
/// outward: a bound is the exact one or the next double beyond it. Throws InputError for no points,
/// for the first that is not finite, and if a sum overflows. Points scaled by a power of two give
/// the k-DOP scaled, as long as nothing overflows or becomes denormal.
KDop<18> bounding_kdop(std::span<const Eigen::Vector3d> points);

/// Returns the smallest k-DOP around both, exactly. Both must be valid.
KDop<18> merged(const KDop<18>& kdop_a, const KDop<18>& kdop_b);

}  // namespace graze
