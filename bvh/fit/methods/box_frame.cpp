#include <graze/bvh/error.h>
#include <graze/bvh/fit/methods/box_frame.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::bvh {
namespace {

constexpr double kLeast = std::numeric_limits<double>::denorm_min();

/// Returns the coordinate axis that is farthest from `v`.
Eigen::Vector3d unlike(const Eigen::Vector3d& v) {
  int least = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(v.data()[k]) < std::abs(v.data()[least])) least = k;
  }
  return Eigen::Vector3d::Unit(least);
}

/// Returns what is left of `v` across the unit vector `axis`, at length 1; zero if nothing is.
Eigen::Vector3d unit_across(Eigen::Vector3d v, const Eigen::Vector3d& axis) {
  for (int twice = 0; twice < 2; ++twice) {  // the second time removes what cancellation left
    const double length = v.norm();
    if (!(length > 0)) return Eigen::Vector3d::Zero();
    v /= length;
    v -= v.dot(axis) * axis;
  }
  const double length = v.norm();
  return length > 0.5 ? Eigen::Vector3d(v / length) : Eigen::Vector3d::Zero();
}

/// Returns the largest sizes of the points' coordinates in the frame, by law 3's very operations.
Eigen::Vector3d largest_coordinates(const Pose& pose, std::span<const Eigen::Vector3d> points) {
  const double* m = pose.data();
  double largest[3] = {0, 0, 0};
  double zeros = 0;  // becomes NaN if a coordinate overflows
  for (const Eigen::Vector3d& point : points) {
    const double* p = point.data();
    const double q[3] = {p[0] - m[12], p[1] - m[13], p[2] - m[14]};
    for (int k = 0; k < 3; ++k) {
      const double* axis = m + 4 * k;
      const double y = std::abs((axis[0] * q[0] + axis[1] * q[1]) + axis[2] * q[2]);
      largest[k] = y > largest[k] ? y : largest[k];
      zeros += 0 * y;
    }
  }
  if (!(zeros == 0)) throw InputError("points too far apart: their box overflows");
  return {largest[0], largest[1], largest[2]};
}

/// Returns half extents that hold the exact coordinates y of the points, y = R^-1 d with d = v - t,
/// given the largest of those that law 3 rounds. Let u = 2^-53, R^T R = I + E with |E_ij| <= e, S
/// the sum of the largest rounded coordinates. From y + E y = R^T d follows |y - R^T d| <= e |y|_1
/// for each coordinate. Law 3 rounds each of the three terms of R^T d four times at most
/// (difference, product, two sums): it is off by 4.01 u |d| <= 4.1 u |y|_1, and by three times half
/// the least denormal where products underflow. |y|_1 is at most 1.01 S and some denormals. The
/// deviation is computed with an error below 4 u. Together y exceeds its rounded value by less than
/// (1.01 e + 9 u) S and 4 denormals, and the last addition rounds by u S: 2 e + 16 u cover that.
/// Along the coordinate axes only the difference rounds, to the nearest: one ulp covers it.
Eigen::Vector3d rounded_outward(const Pose& pose, const Eigen::Vector3d& largest) {
  Eigen::Vector3d half = largest;
  if (pose.linear() == Eigen::Matrix3d::Identity()) {
    for (int k = 0; k < 3; ++k) {
      double& h = half.data()[k];
      if (h > 0) h = std::nextafter(h, std::numeric_limits<double>::infinity());
    }
  } else {
    const double sum = largest.sum();
    const double margin = (2 * rotation_deviation(pose) + 0x1p-49) * sum + 4 * kLeast;
    half.array() += margin;
  }
  if (!half.allFinite()) throw InputError("points too far apart: their box overflows");
  return half;
}

}  // namespace

Axes axes_along(const Eigen::Vector3d& first, const Eigen::Vector3d& second) {
  const double length = first.norm();
  if (!(length > 0)) return Axes::Identity();
  Axes axes;
  axes.col(0) = first / length;
  axes.col(0).normalize();
  Eigen::Vector3d across = unit_across(second, axes.col(0));
  if (across.isZero(0)) across = unit_across(unlike(axes.col(0)), axes.col(0));
  axes.col(1) = across;
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

Extents extents_along(const Axes& axes, const LocalPoints& points) {
  constexpr std::size_t kLanes = LocalPoints::kLanes;
  const double* x = points.axis(0);
  const double* y = points.axis(1);
  const double* z = points.axis(2);
  Extents extents;
  for (int k = 0; k < 3; ++k) {
    const double* axis = axes.data() + 3 * k;
    double low[kLanes];
    double high[kLanes];
    std::fill_n(low, kLanes, std::numeric_limits<double>::infinity());
    std::fill_n(high, kLanes, -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < points.padded_size(); i += kLanes) {
      for (std::size_t j = 0; j < kLanes; ++j) {
        const double h = axis[0] * x[i + j] + axis[1] * y[i + j] + axis[2] * z[i + j];
        low[j] = h < low[j] ? h : low[j];
        high[j] = h > high[j] ? h : high[j];
      }
    }
    extents.low.data()[k] = *std::min_element(low, low + kLanes);
    extents.high.data()[k] = *std::max_element(high, high + kLanes);
  }
  return extents;
}

double half_surface(const Extents& extents) {
  const Eigen::Vector3d size = extents.high - extents.low;
  return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
}

double padded_volume(const Extents& extents) {
  const Eigen::Vector3d size = extents.high - extents.low;
  const double padding = kVolumePadding * size.maxCoeff();
  return (size.x() + padding) * (size.y() + padding) * (size.z() + padding);
}

Obb box_along(const Axes& axes, const LocalPoints& local, std::span<const Eigen::Vector3d> points) {
  Obb box{Pose::Identity(), Eigen::Vector3d::Zero()};
  if (local.is_single()) {
    box.pose.translation() = points.front();
    return box;
  }
  const Extents extents = extents_along(axes, local);
  const Eigen::Vector3d middle = axes * (0.5 * (extents.low + extents.high));
  box.pose.linear() = axes;
  box.pose.translation() = local.to_world(middle);
  box.half_extents = rounded_outward(box.pose, largest_coordinates(box.pose, points));
  return box;
}

}  // namespace graze::bvh
