#pragma once

#include <graze/narrowphase/predicates/exact_vector.h>

#include <Eigen/Core>

namespace graze::narrowphase {

bool is_zero(const BigVector& v);

/// Returns v with length 1, to a few ulp; zero stays.
Eigen::Vector3d unit_of(const BigVector& v);

/// Returns the same, with its sign changed if it goes along d.
Eigen::Vector3d unit_against(const BigVector& v, const BigVector& d);

}  // namespace graze::narrowphase
