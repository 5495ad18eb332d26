#include "tests/bvh/random_boxes.h"

#include <cmath>

#include "tests/shapes/random_source.h"

namespace graze::bvh {
namespace {

struct Extent {
  Eigen::Vector3d low, size;
};

Aabb around(const Extent& extent) {
  return {extent.low, extent.low + extent.size};
}

Aabb one_box(Distribution distribution, std::size_t i, RandomSource& source) {
  switch (distribution) {
    case Distribution::Uniform:
      return around({source.vector(-1, 1), source.vector(0, 0.1)});
    case Distribution::OnePoint:
      return around({{0.3, -0.7, 1e6}, {0, 0, 0}});
    case Distribution::Collinear:
      return around({{source.uniform(0, 1), 2, 2}, {0, 0, 0}});
    case Distribution::GiantAmongDust:
      return i == 0 ? around({{-1e6, -1e6, -1e6}, {2e6, 2e6, 2e6}})
                    : around({source.vector(0, 1e-3), source.vector(0, 1e-6)});
    case Distribution::Exponential: {
      const double scale = std::ldexp(1.0, -static_cast<int>(i % 900));
      return around({Eigen::Vector3d::Constant(scale), Eigen::Vector3d::Constant(scale * 0.01)});
    }
    case Distribution::Flat:
      return around({{source.uniform(0, 1), source.uniform(0, 1), 5}, {0.01, 0.01, 0}});
    case Distribution::Grid:
      return around(
          {{source.integer(0, 7), source.integer(0, 7), source.integer(0, 7)}, {1, 1, 1}});
    case Distribution::Huge:
      return around({source.vector(-1, 1) * 1.7e308, source.vector(0, 1) * 1e306});
    case Distribution::Tiny:
      return around({source.vector(-1, 1) * 1e-318, source.vector(0, 1) * 1e-320});
  }
  return {};
}

}  // namespace

void PrintTo(Distribution distribution, std::ostream* out) {
  constexpr const char* kNames[] = {"Uniform",        "OnePoint",    "Collinear",
                                    "GiantAmongDust", "Exponential", "Flat",
                                    "Grid",           "Huge",        "Tiny"};
  *out << kNames[static_cast<int>(distribution)];
}

std::vector<Aabb> random_boxes(Distribution distribution, std::size_t count, std::uint64_t seed) {
  RandomSource source(seed);
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < count; ++i)
    boxes.push_back(one_box(distribution, i, source));
  return boxes;
}

}  // namespace graze::bvh
