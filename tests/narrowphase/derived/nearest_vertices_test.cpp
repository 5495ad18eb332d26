#include <graze/narrowphase/derived/distance_stages.h>
#include <graze/narrowphase/derived/nearest_vertices.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/shapes/random_source.h"

namespace graze::narrowphase {
namespace {

/// A triangle with this corner, which may be any of its three.
Triangle triangle_with(const Eigen::Vector3d& corner, const Eigen::Vector3d& one,
                       const Eigen::Vector3d& other, int place) {
  if (place == 0) return {corner, one, other};
  return place == 1 ? Triangle{other, corner, one} : Triangle{one, other, corner};
}

// Law 9: what is known is what would have been computed.
TEST(Law9NearestVertices, AnswerAsTheDistanceDoes) {
  RandomSource source(61);
  int known = 0, unknown = 0;
  for (int n = 0; n < 3000; ++n) {
    const double scale = std::pow(2.0, source.integer(-60, 60));
    const Eigen::Vector3d p = scale * source.vector(-1, 1);
    const Eigen::Vector3d q = p + scale * source.vector(-1, 1);
    const Eigen::Vector3d way = q - p;
    const auto around_p = [&]() -> Eigen::Vector3d {
      return p - 0.4 * way + 0.5 * scale * source.vector(-1, 1);
    };
    const auto around_q = [&]() -> Eigen::Vector3d {
      return q + 0.4 * way + 0.5 * scale * source.vector(-1, 1);
    };
    const auto a = [&] {
      const Eigen::Vector3d second = around_p(), third = around_p();
      return triangle_with(p, second, third, static_cast<int>(source.integer(0, 2)));
    };
    const auto b = [&] {
      const Eigen::Vector3d second = around_q(), third = around_q();
      return triangle_with(q, second, third, static_cast<int>(source.integer(0, 2)));
    };
    NearestVertices vertices;
    vertices.set(decide_distance(a(), b()).result);
    for (int k = 0; k < 8; ++k) {
      const Triangle one = a();
      const Triangle other = b();
      const TriangleDistance* found = vertices.of(one, other);
      if (found) {
        EXPECT_EQ(*found, decide_distance(one, other).result);
      }
      EXPECT_EQ(vertices.of(other, one), nullptr);
      (found ? known : unknown) += 1;
    }
  }
  EXPECT_GT(known, 1000);
  EXPECT_GT(unknown, 1000);
}

TEST(NearestVertices, OthersThanVerticesTellNothing) {
  const Triangle a{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  const Triangle above{{0.5, 0.5, 1}, {1, 1, 2}, {0, 1, 2}};
  NearestVertices vertices;
  vertices.set(decide_distance(a, above).result);
  EXPECT_EQ(vertices.of(a, above), nullptr);
}

// Halfway between two doubles stages may round otherwise.
TEST(NearestVertices, NothingIsKnownWhereRoundingIsInDoubt) {
  const auto at = [](double x) { return Triangle{{x, 0, 0}, {-1, 1, 0}, {-1, 0, 1}}; };
  const Triangle beside{{1, 0, 0}, {2, 1, 0}, {2, 0, 1}};
  NearestVertices vertices;
  vertices.set(decide_distance(at(-0x1p-53), beside).result);
  EXPECT_EQ(vertices.of(at(-0x1p-53), beside), nullptr);
  vertices.set(decide_distance(at(-0x1p-52), beside).result);
  EXPECT_NE(vertices.of(at(-0x1p-52), beside), nullptr);
  // The root is so near to halfway that 2^-20 of the way are missing.
  vertices.set(decide_distance(at(-0x1p-53 * (1 - 0x1p-30)), beside).result);
  EXPECT_EQ(vertices.of(at(-0x1p-53 * (1 - 0x1p-30)), beside), nullptr);
}

}  // namespace
}  // namespace graze::narrowphase
