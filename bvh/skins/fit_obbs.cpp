#include <graze/bvh/fit/obb_fit.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/skins/fit_skins.h>
#include <graze/bvh/value/parallel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::bvh {
namespace {

/// Returns a box with the axes of `frame`, and the centre of the points along them.
FloatObb centred_along(std::span<const Eigen::Vector3d> points, const Pose& frame) {
  const double* m = frame.data();  // column-major 4x4: column i is axis i
  double low[3], high[3];
  for (int i = 0; i < 3; ++i) {
    low[i] = std::numeric_limits<double>::infinity();
    high[i] = -low[i];
    for (const Eigen::Vector3d& point : points) {
      const double* p = point.data();
      const double along = m[4 * i] * p[0] + m[4 * i + 1] * p[1] + m[4 * i + 2] * p[2];
      low[i] = std::min(low[i], along);
      high[i] = std::max(high[i], along);
    }
  }
  FloatObb box;
  for (int k = 0; k < 3; ++k) {
    double centre = 0;
    for (int i = 0; i < 3; ++i) {
      box.axes[i][k] = static_cast<float>(m[4 * i + k]);
      centre += m[4 * i + k] * 0.5 * (low[i] + high[i]);
    }
    box.centre[k] = static_cast<float>(centre);
  }
  return box;
}

/// Sets the half extents about the centre and axes as they are in float.
void set_half_extents(FloatObb& box, std::span<const Eigen::Vector3d> points) {
  double half[3] = {0, 0, 0};
  double largest = 0;
  for (const Eigen::Vector3d& point : points) {
    double offset[3];
    double norm = 0;
    for (int k = 0; k < 3; ++k) {
      offset[k] = point.data()[k] - box.centre[k];
      norm += std::abs(offset[k]);
    }
    largest = std::max(largest, norm);
    for (int i = 0; i < 3; ++i) {
      const double along =
          box.axes[i][0] * offset[0] + box.axes[i][1] * offset[1] + box.axes[i][2] * offset[2];
      half[i] = std::max(half[i], std::abs(along));
    }
  }
  // Seen from the rotation that the axes stand for, each component of which is within kAxisError, a
  // coordinate is off by kAxisError times the 1-norm of the offset, and by the points' rounding.
  const double margin = 1.01 * FloatObb::kAxisError * largest + 4 * Hulls::kRounding;
  for (int i = 0; i < 3; ++i)
    box.half[i] = rounded_up(half[i] + margin);
}

double surface(const FloatObb& box) {
  const double x = box.half[0], y = box.half[1], z = box.half[2];
  return x * y + y * z + z * x;
}

FloatObb fitted(std::span<const Eigen::Vector3d> points) {
  FloatObb best = centred_along(points, Pose::Identity());
  set_half_extents(best, points);
  FloatObb turned = centred_along(points, ditetrahedron_box(points).pose);
  set_half_extents(turned, points);
  return surface(turned) < surface(best) ? turned : best;
}

}  // namespace

std::vector<FloatObb> fit_obbs(const Tree& tree, const Hulls& hulls) {
  std::vector<FloatObb> skin(tree.nodes.size());
  for_in_parallel(std::size_t{0}, skin.size(), [&](std::size_t node) {
    in_standard_arithmetic([&] { skin[node] = fitted(hulls.below(node)); });
  });
  return skin;
}

}  // namespace graze::bvh
