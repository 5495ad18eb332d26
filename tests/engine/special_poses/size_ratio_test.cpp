// Partners of which the one is up to a hundred million times as large as the other, beside edges,
// tips and sides: what is proved about the depth of the small one, and where its contacts stand.

#include <graze/engine/world/manifold.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/engine/special_poses/pair_laws.h"
#include "tests/engine/special_poses/pair_text.h"
#include "tests/engine/special_poses/special_pairs.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/shape_kinds.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::PlacedPair;

/// The first at the origin, the second scaled and parted from it by `gap` of its size; towards an
/// axis of the first it is at an end, an edge or a side of that.
PlacedPair beside(const Shape& large, const Shape& other, double ratio, double gap,
                  RandomSource& source) {
  PlacedPair pair{large, other, Pose::Identity(), Pose::Identity()};
  pair.b = tests::scaled({other, other, Pose::Identity(), Pose::Identity()}, ratio).a;
  pair.pose_b.linear() = tests::right_turn(static_cast<std::size_t>(source.integer(0, 23)));
  Vector3d out = source.vector(-1, 1).normalized();
  if (source.integer(0, 1) == 0) {
    const int axis = source.integer(0, 2);
    out = Vector3d::Unit(axis) * (source.integer(0, 1) == 0 ? 1.0 : -1.0);
  }
  pair.pose_b.translation() = out * width_along(pair, out);
  const tests::LeastWidth least = tests::least_width(pair, 200, {out});
  pair.pose_b.translation() += least.direction * (least.width + gap * smaller_size(pair));
  return pair;
}

template <typename Draw>
void expect_all_kept(std::uint64_t seed, Draw&& draw) {
  tests::PairLawCounts counts;
  RandomSource source(seed);
  for (std::size_t n = 0; n < 4000; ++n) {
    const PlacedPair pair = draw(n, std::pow(10.0, source.uniform(-8, -2)), source);
    ASSERT_EQ(broken_law(pair, {.directions = 200}, counts), "") << text_of(pair);
  }
  EXPECT_GT(counts.hits, 1000u);
}

// Where radii alone overlap, an expanding polytope of the cores has the origin outside, and the
// heights of its faces bound nothing.
TEST(SpecialPoses, SmallPartnersBesideTheAxisOfARoundOneAreAsDeepAsTheyAre) {
  expect_all_kept(93, [](std::size_t n, double ratio, RandomSource& source) {
    const Shape large =
        tests::plain_shape(n % 4 == 0 ? ShapeKind::Sphere : ShapeKind::Capsule, n / 4);
    const Shape small = tests::plain_shape(tests::kOwnKinds[n / 4 % tests::kConvexKinds], n / 28);
    PlacedPair pair = beside(large, small, ratio, 0, source);
    pair.pose_b.translation() = source.vector(-1, 1) * (2 * smaller_size(pair));
    pair.pose_b.translation().z() += source.uniform(0, 0.25);
    pair.pose_a.rotate(Eigen::AngleAxisd{source.uniform(0, 3), source.vector(-1, 1).normalized()});
    pair.pose_b = pair.pose_a * pair.pose_b;
    return pair;
  });
}

TEST(SpecialPoses, SmallPartnersThatOnlyTouchStandWhereTheyDo) {
  expect_all_kept(94, [](std::size_t n, double ratio, RandomSource& source) {
    const Shape large = tests::plain_shape(tests::kOwnKinds[n % tests::kConvexKinds], n / 49);
    const Shape small = tests::plain_shape(tests::kOwnKinds[n / 7 % tests::kConvexKinds], n / 49);
    return beside(large, small, ratio, source.uniform(-1e-6, 1e-9), source);
  });
}

// A polytope's narrow faces have planes that rounding tilts, by more than the depth where the large
// partner's size is in them: such a plane was taken to be as far as it seemed, and a depth that was
// up to twice the least for proved.
TEST(SpecialPoses, DepthsBesidePartnersABillionTimesAsLargeAreAsDeepAsTheyAre) {
  tests::PairLawCounts counts;
  RandomSource source(103);
  for (std::size_t n = 0; n < 4000; ++n) {
    const double size = std::pow(10.0, source.uniform(6, 9));
    std::vector<Vector3d> corners;
    for (int i = 0; i < 6 && n % 2 == 1; ++i)
      corners.emplace_back(source.vector(-1, 1) * size);
    const double flat = size * std::pow(10.0, source.uniform(-9, 0));
    if (n % 2 == 0)
      corners = {{-size, 0, flat}, {size, 0, flat}, {0, -size, -flat}, {0, size, -flat}};
    PlacedPair pair{ConvexHull(corners),
                    tests::plain_shape(tests::kOwnKinds[n / 2 % tests::kConvexKinds], n / 14),
                    tests::random_pose(0, source), tests::random_pose(0, source)};
    pair.pose_a.translation().setZero();
    const Vector3d feature =
        source.integer(0, 1) == 0 ? corners[0] : Vector3d((corners[0] + corners[1]) * 0.5);
    pair.pose_b.translation() =
        pair.pose_a * feature + source.vector(-1, 1) * (0.5 * tests::size_about_middle(pair.b));
    ASSERT_EQ(broken_law(pair, {.directions = 100}, counts), "") << n << "\n" << text_of(pair);
  }
  EXPECT_GT(counts.hits, 3000u);
  EXPECT_LT(counts.unproved, counts.hits / 10);
}

}  // namespace
}  // namespace graze
