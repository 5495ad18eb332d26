#pragma once

#include <graze/bvh/fit/methods/local_points.h>
#include <graze/bvh/obb.h>

#include <Eigen/Core>
#include <span>

namespace graze::bvh {

/// The axes of a box, as columns.
using Axes = Eigen::Matrix3d;

/// Returns a right-handed frame along `first`, with its second axis in the plane of both; where
/// they have none, any such frame. A first of zero length gives the coordinate axes.
Axes axes_along(const Eigen::Vector3d& first, const Eigen::Vector3d& second);

/// The lowest and highest coordinates of points along axes, in local units.
struct Extents {
  Eigen::Vector3d low;
  Eigen::Vector3d high;
};

Extents extents_along(const Axes& axes, const LocalPoints& points);

/// Returns half the surface of the box.
double half_surface(const Extents& extents);

/// Returns the volume after a billionth of the size is added to each extent: so it orders boxes of
/// flat and of straight sets too.
double padded_volume(const Extents& extents);
inline constexpr double kVolumePadding = 1e-9;

/// Returns the box along `axes` around `points`, which `local` was made from, rounded outward as
/// obb_fit.h says; throws as it says.
Obb box_along(const Axes& axes, const LocalPoints& local, std::span<const Eigen::Vector3d> points);

}  // namespace graze::bvh
