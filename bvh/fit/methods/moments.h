#pragma once

#include <graze/bvh/fit/methods/box_frame.h>
#include <graze/bvh/fit/methods/local_points.h>

namespace graze::bvh {

/// Returns the covariance of the points in local units: symmetric, not negative.
Eigen::Matrix3d covariance(const LocalPoints& points);

/// Returns the eigenvectors of a covariance, as a frame.
Axes principal_axes(const Eigen::Matrix3d& covariance);

}  // namespace graze::bvh
