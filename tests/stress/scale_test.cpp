// One configuration in many sizes, places and poses. Scaled by a power of two it is the same to the
// last bit, and so is the answer; otherwise rounding makes another of it, for which the referee
// knows the truth.

#include <graze/engine/compare/referee.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>
#include <tests/oracle/category.h>
#include <tests/oracle/shapes.h>

#include <cmath>

#include "tests/shapes/closed_meshes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"
#include "tests/stress/sweeps.h"

namespace graze::stress {
namespace {

using oracle::TrianglePair;

/// Whether scaling by 2^-40 to 2^40 rounds none of the coordinates.
bool is_scalable(const TrianglePair& pair) {
  bool is_fine = true;
  for (const Triangle& t : {pair.a, pair.b}) {
    for (const Eigen::Vector3d& p : {t.a, t.b, t.c}) {
      for (int k = 0; k < 3; ++k)
        is_fine &= p[k] == 0 || (std::abs(p[k]) > 0x1p-900 && std::abs(p[k]) < 0x1p+900);
    }
  }
  return is_fine;
}

TEST(StressScale, PowersOfTwoChangeNoAnswer) {
  int compared = 0;
  int hits = 0;
  for (const oracle::Corpus<TrianglePair>& corpus : oracle::pair_corpora()) {
    for (std::uint64_t index = 0; index < 60; ++index) {
      const TrianglePair pair = corpus.element(index);
      if (!is_scalable(pair)) continue;
      const bool is_hit = intersects(pair.a, pair.b);
      const bool is_crossing = crosses(pair.a, pair.b);
      for (const int exponent : {-40, -13, -1, 1, 17, 40}) {
        const TrianglePair scaled = oracle::scaled(pair, std::ldexp(1.0, exponent));
        ASSERT_EQ(intersects(scaled.a, scaled.b), is_hit) << corpus.name() << ' ' << index;
        ASSERT_EQ(crosses(scaled.a, scaled.b), is_crossing) << corpus.name() << ' ' << index;
      }
      ++compared;
      hits += is_hit;
    }
  }
  EXPECT_GT(compared, 4000);
  EXPECT_GT(hits, 1000);
  EXPECT_LT(hits, compared - 1000);
}

constexpr double kScales[] = {1e-12, 1e-9, 1e-6, 1e-3, 1, 1e3, 1e6, 1e9, 1e12};
constexpr double kOffsets[] = {0, 1, 1e3, 1e6, 1e9};

void check_rows(const std::vector<SweepRow>& rows, std::size_t cases) {
  for (const SweepRow& row : rows) {
    EXPECT_EQ(row.cases, cases);
    EXPECT_EQ(row.wrong, 0u) << row.value;
    EXPECT_GT(row.hits, cases / 10) << row.value;
    EXPECT_LT(row.hits, cases - cases / 10) << row.value;
  }
}

void check_sweeps(std::size_t cases) {
  for (const double offset : {0.0, 1.0, 1e6})
    check_rows(sweep_scales(offset, cases), cases);
  check_rows(sweep_offsets(cases), cases);
}

TEST(StressScale, PlacedTrianglesAreTheReferees) {
  check_sweeps(150);
}

TEST(StressScaleSlow, PlacedTrianglesAreTheReferees) {
  check_sweeps(50000);
}

/// All pairs by the referee.
std::vector<graze::TrianglePair> pairs_by_referee(const PlacedMesh& a, const PlacedMesh& b) {
  std::vector<graze::TrianglePair> pairs;
  for (std::uint32_t i = 0; i < a.mesh.triangles().size(); ++i) {
    for (std::uint32_t j = 0; j < b.mesh.triangles().size(); ++j) {
      if (compare::referee_intersects(place(a.pose, a.mesh.triangle(i)),
                                      place(b.pose, b.mesh.triangle(j))))
        pairs.push_back({i, j});
    }
  }
  return pairs;
}

TEST(StressScale, PlacedMeshesAreTheReferees) {
  RandomSource source(2);
  const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  const Mesh ball = tests::make_sphere(1, 4, 6);
  const Mesh box = tests::make_box({0.5, 0.5, 0.5});
  std::size_t found = 0;
  for (const double scale : kScales) {
    const Mesh scaled_ball = tests::mapped(ball, scale, origin);
    const Mesh scaled_box = tests::mapped(box, scale, origin);
    for (const double offset : kOffsets) {
      // A face of the box on the ball's pole, or nearly, once rotated and far away.
      const Pose pose = tests::random_pose(offset, source);
      const Pose above = pose * Eigen::Translation3d(0, 0, 1.5 * scale);
      const PlacedMesh a{scaled_ball, pose};
      const PlacedMesh b{scaled_box, Pose(above)};
      const auto expected = pairs_by_referee(a, b);
      found += expected.size();
      for (const PairVolume volume : kPairVolumes)
        ASSERT_EQ(find_triangle_pairs(a, b, {.volume = volume}).pairs, expected)
            << scale << ' ' << offset << ' ' << name_of(volume);
    }
  }
  EXPECT_GT(found, 50u);
}

}  // namespace
}  // namespace graze::stress
