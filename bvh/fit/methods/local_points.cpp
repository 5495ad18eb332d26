#include <graze/bvh/fit/aabb_fit.h>
#include <graze/bvh/fit/methods/local_points.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {
namespace {

constexpr std::size_t kLanes = LocalPoints::kLanes;
constexpr std::size_t kBlock = 16 * kLanes;

/// Returns the largest squared distance from c of points [begin, end), a whole number of lanes.
double largest_squared_distance(const LocalPoints& points, const double* c, std::size_t begin,
                                std::size_t end) {
  const double* x = points.axis(0);
  const double* y = points.axis(1);
  const double* z = points.axis(2);
  double largest[kLanes] = {0, 0, 0, 0};
  for (std::size_t i = begin; i < end; i += kLanes) {
    for (std::size_t k = 0; k < kLanes; ++k) {
      const double dx = x[i + k] - c[0];
      const double dy = y[i + k] - c[1];
      const double dz = z[i + k] - c[2];
      const double squared = dx * dx + dy * dy + dz * dz;
      largest[k] = squared > largest[k] ? squared : largest[k];
    }
  }
  return std::max(std::max(largest[0], largest[1]), std::max(largest[2], largest[3]));
}

}  // namespace

LocalPoints::LocalPoints(std::span<const Eigen::Vector3d> points)
    : bounds_(bounding_aabb(points)),
      frame_(LocalFrame::around(bounds_)),
      scale_(std::ldexp(1.0, -frame_.exponent)),
      size_(points.size()),
      padded_((size_ + kLanes - 1) / kLanes * kLanes),
      coordinates_(std::make_unique_for_overwrite<double[]>(3 * padded_)) {
  double* out[3] = {coordinates_.get(), coordinates_.get() + padded_,
                    coordinates_.get() + 2 * padded_};
  for (std::size_t i = 0; i < padded_; ++i) {
    const double* p = points[std::min(i, size_ - 1)].data();
    for (int k = 0; k < 3; ++k)
      out[k][i] = (p[k] - frame_.centre[k]) * scale_;
  }
}

Eigen::Vector3d LocalPoints::to_local(const Eigen::Vector3d& point) const {
  Eigen::Vector3d local;
  for (int k = 0; k < 3; ++k)
    local.data()[k] = (point.data()[k] - frame_.centre[k]) * scale_;
  return local;
}

Eigen::Vector3d LocalPoints::to_world(const Eigen::Vector3d& local) const {
  const double unit = frame_.unit();
  Eigen::Vector3d point;
  for (int k = 0; k < 3; ++k) {
    point.data()[k] = frame_.centre[k] + local.data()[k] * unit;
  }
  return point;
}

FarPoint farthest_point(const LocalPoints& points, const Eigen::Vector3d& centre) {
  const double* c = centre.data();
  std::size_t best_block = 0;
  double best = -1;
  for (std::size_t begin = 0; begin < points.padded_size(); begin += kBlock) {
    const double squared =
        largest_squared_distance(points, c, begin, std::min(begin + kBlock, points.padded_size()));
    if (squared > best) {
      best = squared;
      best_block = begin;
    }
  }
  // The point is found again by the same operations, so that its distance compares equal.
  for (std::size_t i = best_block;; ++i) {
    const double dx = points.axis(0)[i] - c[0];
    const double dy = points.axis(1)[i] - c[1];
    const double dz = points.axis(2)[i] - c[2];
    if (dx * dx + dy * dy + dz * dz == best) return {i, best};
  }
}

}  // namespace graze::bvh
