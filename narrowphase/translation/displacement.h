#pragma once

#include <Eigen/Core>

namespace graze::narrowphase {

/// Throws InputError for a component that is not finite.
void check_displacement(const Eigen::Vector3d& displacement);

}  // namespace graze::narrowphase
