#include <graze/bvh/error.h>
#include <graze/bvh/fit/aabb_fit.h>
#include <graze/bvh/fit/kdop_fit.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace graze {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kSums = 6;

/// The directions of slabs 3 to 8: coordinate `first` plus `sign` times coordinate `second`.
struct SumOfTwo {
  int first;
  int second;
  double sign;
};

constexpr std::array<SumOfTwo, kSums> sums_of_two() {
  std::array<SumOfTwo, kSums> sums{};
  for (int i = 0; i < kSums; ++i) {
    const std::array<int, 3>& direction = kKDopDirections<18>[i + 3];
    const int first = direction[0] != 0 ? 0 : 1;
    const int second = direction[2] != 0 ? 2 : 1;
    sums[i] = {first, second, static_cast<double>(direction[second])};
  }
  return sums;
}

constexpr std::array<SumOfTwo, kSums> kSumsOfTwo = sums_of_two();

/// Writes the six sums of a point, rounded, in the order of the slabs.
void round_sums(const double* p, double* sums) {
  sums[0] = p[0] + p[1];
  sums[1] = p[0] + p[2];
  sums[2] = p[1] + p[2];
  sums[3] = p[0] - p[1];
  sums[4] = p[0] - p[2];
  sums[5] = p[1] - p[2];
}

/// Returns by how much a + b exceeds its rounded sum, exactly (Knuth's two-sum).
double rounding_error(double a, double b, double sum) {
  const double b_part = sum - a;
  const double a_part = sum - b_part;
  return (a - a_part) + (b - b_part);
}

/// Moves outward the bounds that a point exceeds. Rounding to the nearest keeps order: only points
/// whose rounded sum is the extreme can lie beyond it, and by less than a step.
void step_outward(KDop<18>& kdop, std::span<const Eigen::Vector3d> points) {
  bool exceeds_low[kSums] = {};
  bool exceeds_high[kSums] = {};
  for (const Eigen::Vector3d& point : points) {
    const double* p = point.data();
    double sums[kSums];
    round_sums(p, sums);
    for (int i = 0; i < kSums; ++i) {
      const bool is_low = sums[i] == kdop.min[i + 3];
      const bool is_high = sums[i] == kdop.max[i + 3];
      if (!is_low && !is_high) continue;
      const SumOfTwo& direction = kSumsOfTwo[i];
      const double error =
          rounding_error(p[direction.first], direction.sign * p[direction.second], sums[i]);
      exceeds_low[i] |= is_low && error < 0;
      exceeds_high[i] |= is_high && error > 0;
    }
  }
  for (int i = 0; i < kSums; ++i) {
    if (exceeds_low[i]) kdop.min[i + 3] = std::nextafter(kdop.min[i + 3], -kInfinity);
    if (exceeds_high[i]) kdop.max[i + 3] = std::nextafter(kdop.max[i + 3], kInfinity);
  }
}

void refuse_overflow(const KDop<18>& kdop) {
  for (int i = 0; i < KDop<18>::kSlabs; ++i) {
    if (!std::isfinite(kdop.min[i]) || !std::isfinite(kdop.max[i])) {
      throw InputError(
          "points too far out: slab " + std::to_string(i) + " of their k-DOP overflows",
          {.element = "slab", .index = static_cast<std::size_t>(i)});
    }
  }
}

}  // namespace

KDop<18> bounding_kdop(std::span<const Eigen::Vector3d> points) {
  return bvh::in_standard_arithmetic([&]() -> KDop<18> {
    const Aabb box = bounding_aabb(points);
    double low[kSums];
    double high[kSums];
    std::fill_n(low, kSums, kInfinity);
    std::fill_n(high, kSums, -kInfinity);
    for (const Eigen::Vector3d& point : points) {
      double sums[kSums];
      round_sums(point.data(), sums);
      for (int i = 0; i < kSums; ++i) {
        low[i] = sums[i] < low[i] ? sums[i] : low[i];
        high[i] = sums[i] > high[i] ? sums[i] : high[i];
      }
    }
    KDop<18> kdop;
    for (int k = 0; k < 3; ++k) {
      kdop.min[k] = box.min.data()[k];
      kdop.max[k] = box.max.data()[k];
    }
    for (int i = 0; i < kSums; ++i) {
      kdop.min[i + 3] = low[i];
      kdop.max[i + 3] = high[i];
    }
    refuse_overflow(kdop);
    step_outward(kdop, points);
    refuse_overflow(kdop);
    return kdop;
  });
}

KDop<18> merged(const KDop<18>& kdop_a, const KDop<18>& kdop_b) {
  return bvh::in_standard_arithmetic([&]() -> KDop<18> {
    KDop<18> kdop;
    for (int i = 0; i < KDop<18>::kSlabs; ++i) {
      kdop.min[i] = std::min(kdop_a.min[i], kdop_b.min[i]);
      kdop.max[i] = std::max(kdop_a.max[i], kdop_b.max[i]);
    }
    return kdop;
  });
}

}  // namespace graze
