#include <graze/narrowphase/convex/core/point_rows.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <vector>

#include "tests/narrowphase/simd_targets.h"
#include "tests/shapes/random_source.h"

namespace graze::narrowphase {
namespace {

/// On a grid several points are as far as each other.
std::vector<Vec3> points_of_a_grid(std::size_t count, RandomSource& source) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({source.integer(-3, 3), source.integer(-3, 3), source.integer(-3, 3)});
  return points;
}

std::size_t farthest_one_by_one(const std::vector<Vec3>& points, const Vec3& direction,
                                std::size_t count) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < count; ++i)
    if (dot(points[i], direction) > dot(points[best], direction)) best = i;
  return best;
}

std::size_t next_one_by_one(const std::vector<Vec3>& points, const Vec3& direction, double along,
                            std::size_t from) {
  while (from < points.size() && !(dot(points[from], direction) >= along))
    ++from;
  return from;
}

TEST(Law8PointRows, EverySimdTargetFindsTheFirstOfTheFarthestPoints) {
  for (const std::int64_t target : simd_targets()) {
    force_simd_target(target);
    RandomSource source(1);
    for (std::size_t size = 1; size < 60; ++size) {
      const std::vector<Vec3> points = points_of_a_grid(size, source);
      PointRows rows;
      for (const Vec3& point : points)
        rows.add(point);
      for (int k = 0; k < 20; ++k) {
        Vec3 direction{source.integer(-2, 2), source.integer(-2, 2), source.integer(-2, 2)};
        if (k % 2 != 0) direction = direction * source.uniform(0.1, 1);
        const auto count = static_cast<std::size_t>(source.integer(1, static_cast<int>(size)));
        const std::size_t best = farthest_one_by_one(points, direction, count);
        EXPECT_EQ(rows.farthest(direction, count), best);
        const double along = dot(points[best], direction);
        for (const std::size_t from : {std::size_t{0}, count / 2, count}) {
          EXPECT_EQ(rows.next_beyond(direction, along, from),
                    next_one_by_one(points, direction, along, from));
        }
      }
    }
  }
  force_simd_target(0);
}

TEST(PointRows, WhatIsClearedHoldsNothing) {
  PointRows rows;
  rows.add({5, 0, 0});
  rows.clear();
  rows.add({1, 0, 0}), rows.add({2, 0, 0});
  EXPECT_EQ(rows.farthest({1, 0, 0}, 2), 1u);
  const double never = std::numeric_limits<double>::infinity();
  EXPECT_EQ(rows.next_beyond({1, 0, 0}, never, 0), 2u);
}

}  // namespace
}  // namespace graze::narrowphase
