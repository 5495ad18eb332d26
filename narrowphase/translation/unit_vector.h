#pragma once

#include <graze/narrowphase/predicates/exact_vector.h>

#include <Eigen/Core>

namespace graze::narrowphase {

bool is_zero(const BigVector& v);

/// With length 1, to a few ulp; zero stays.
Eigen::Vector3d unit_of(const BigVector& v);

/// Likewise, against d as far as it is along it.
Eigen::Vector3d unit_against(const BigVector& v, const BigVector& d);

}  // namespace graze::narrowphase
