// The cells of a face that large triangles cut from edge to edge, each known by the sides of these
// on which it lies.

#include <graze/engine/mesh/solids/face_cells.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using Sides = std::vector<bool>;

Eigen::Vector3d normal_of(const Triangle& triangle) {
  return (triangle.b - triangle.a).cross(triangle.c - triangle.a);
}

/// How far a point is above the plane of a triangle, times twice its area.
double height(const Triangle& triangle, const Eigen::Vector3d& point) {
  return normal_of(triangle).dot(point - triangle.a);
}

Sides sides_of(const std::vector<Triangle>& cutters, const Eigen::Vector3d& point) {
  Sides sides;
  for (const Triangle& cutter : cutters)
    sides.push_back(height(cutter, point) > 0);
  return sides;
}

TEST(FaceCells, EachHasAPoint) {
  RandomSource source(61);
  std::size_t most = 0;
  for (int n = 0; n < 60; ++n) {
    const Triangle face{source.vector(-1, 1), source.vector(-1, 1), source.vector(-1, 1)};
    const auto inside = [&](double s, double t) {
      return Eigen::Vector3d(face.a + s * (face.b - face.a) + t * (face.c - face.a));
    };
    std::vector<Triangle> cutters;
    for (int i = 0; i < n % 8; ++i) {
      const double first = source.uniform(0.1, 0.4);
      const Eigen::Vector3d middle = inside(first, source.uniform(0.1, 0.4));
      const Eigen::Vector3d p = 40 * source.vector(-1, 1), q = 40 * source.vector(-1, 1);
      cutters.push_back({middle + p, middle + q, middle - p - q});
    }
    std::set<Sides> seen;
    const auto see = [&](const narrowphase::RationalPoint& point) {
      const Aabb box = narrowphase::box_around(point);
      EXPECT_LE((box.max - box.min).maxCoeff(), 1e-14);
      const Eigen::Vector3d at = box.min / 2 + box.max / 2;
      EXPECT_NEAR(height(face, at), 0, 1e-13);
      seen.insert(sides_of(cutters, at));
      return false;
    };
    EXPECT_FALSE(FaceCells(face, cutters).any(see));
    std::set<Sides> wanted;
    constexpr int kSteps = 150;
    for (int i = 1; i < kSteps; ++i) {
      for (int k = 1; i + k < kSteps; ++k) {
        const Eigen::Vector3d at = inside(double(i) / kSteps, double(k) / kSteps);
        const bool is_clear =
            std::all_of(cutters.begin(), cutters.end(),
                        [&](const Triangle& each) { return std::abs(height(each, at)) > 1e-9; });
        if (is_clear) wanted.insert(sides_of(cutters, at));
      }
    }
    EXPECT_TRUE(std::includes(seen.begin(), seen.end(), wanted.begin(), wanted.end())) << n;
    most = std::max(most, wanted.size());
  }
  EXPECT_GT(most, 15u);
}

TEST(FaceCells, EndWhereAVisitDoes) {
  const Triangle face{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
      wall{{0.5, -9, 9}, {0.5, 9, 9}, {0.5, 0, -9}};
  int all = 0, some = 0;
  EXPECT_FALSE(FaceCells(face, {&wall, 1}).any([&](const auto&) { return ++all == 0; }));
  EXPECT_GE(all, 2);
  EXPECT_TRUE(FaceCells(face, {&wall, 1}).any([&](const auto&) { return ++some == 1; }));
  EXPECT_EQ(some, 1);
}

}  // namespace
}  // namespace graze
