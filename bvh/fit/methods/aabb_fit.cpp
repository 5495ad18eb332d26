#include <graze/bvh/error.h>
#include <graze/bvh/fit/aabb_fit.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <cmath>
#include <string>

namespace graze {
namespace {

[[noreturn]] void refuse(std::span<const Eigen::Vector3d> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      if (!std::isfinite(points[i].data()[k])) {
        throw InputError(
            "point " + std::to_string(i) + ": coordinate " + "xyz"[k] + " is not finite",
            {.element = "point", .index = i});
      }
    }
  }
  throw InputError("no points to fit a volume to");
}

}  // namespace

Aabb bounding_aabb(std::span<const Eigen::Vector3d> points) {
  return bvh::in_standard_arithmetic([&]() -> Aabb {
    if (points.empty()) refuse(points);
    const double* first = points.front().data();
    double low[3] = {first[0], first[1], first[2]};
    double high[3] = {first[0], first[1], first[2]};
    double zeros[3] = {0, 0, 0};  // 0 times anything that is not finite is NaN, and stays so
    for (const Eigen::Vector3d& point : points) {
      const double* p = point.data();
      for (int k = 0; k < 3; ++k) {
        low[k] = p[k] < low[k] ? p[k] : low[k];
        high[k] = p[k] > high[k] ? p[k] : high[k];
        zeros[k] += 0 * p[k];
      }
    }
    if (!(zeros[0] + zeros[1] + zeros[2] == 0)) refuse(points);
    return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
  });
}

Aabb merged(const Aabb& box_a, const Aabb& box_b) {
  return bvh::in_standard_arithmetic([&]() -> Aabb {
    return {box_a.min.cwiseMin(box_b.min), box_a.max.cwiseMax(box_b.max)};
  });
}

}  // namespace graze
