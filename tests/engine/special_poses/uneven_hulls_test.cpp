// Hulls whose faces are flat to a millionth alone: contacts count such facets as one face, but each
// point is on the hull itself.

#include <graze/engine/world/manifold.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/engine/special_poses/pair_laws.h"
#include "tests/engine/special_poses/pair_text.h"
#include "tests/engine/special_poses/special_pairs.h"
#include "tests/shapes/shape_kinds.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::PlacedPair;

/// A prism, a box or a pyramid, each of whose corners is moved by about `unevenness`.
ConvexHull uneven_hull(std::size_t kind, double unevenness, RandomSource& source) {
  std::vector<Vector3d> corners;
  const int sides = 3 + static_cast<int>(kind % 5);
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * M_PI * i / sides;
    corners.emplace_back(std::cos(angle), std::sin(angle), -0.6);
    if (kind % 2 == 0) corners.emplace_back(std::cos(angle), std::sin(angle), 0.6);
  }
  if (kind % 2 == 1) corners.emplace_back(0, 0, 0.6);
  for (Vector3d& corner : corners)
    corner += source.vector(-1, 1) * unevenness;
  return ConvexHull(corners);
}

/// The hull and a partner that rests on a face, or nearly, and is sunk into it by a little or much.
PlacedPair resting(const Shape& hull, const Shape& other, RandomSource& source) {
  PlacedPair pair{hull, other, Pose::Identity(), Pose::Identity()};
  pair.pose_b.linear() = tests::right_turn(static_cast<std::size_t>(source.integer(0, 23)));
  const double angle = source.uniform(0, 7);
  const Vector3d out = source.integer(0, 1) == 0
                           ? Vector3d(0, 0, source.integer(0, 1) == 0 ? 1 : -1)
                           : Vector3d(std::cos(angle), std::sin(angle), 0);
  const tests::LeastWidth least = tests::least_width(pair, 100, {out});
  pair.pose_b.translation() += out * width_along(pair, out) + source.vector(-0.4, 0.4);
  const double depth = std::pow(10.0, source.uniform(-9, -1));
  const tests::LeastWidth placed = tests::least_width(pair, 200, {out, least.direction});
  pair.pose_b.translation() += placed.direction * (placed.width - depth);
  return pair;
}

TEST(SpecialPoses, ContactsOfUnevenHullsStandOnThem) {
  tests::PairLawCounts counts;
  RandomSource source(91);
  for (int n = 0; n < 2000; ++n) {
    const auto kind = static_cast<std::size_t>(n);
    const double unevenness = std::pow(10.0, source.uniform(-12, -5));
    const Shape hull = uneven_hull(kind / 7, unevenness, source);
    const Shape other = kind % 8 == 7 ? Shape(uneven_hull(kind, unevenness, source))
                                      : tests::plain_shape(tests::kOwnKinds[kind % 7], kind / 49);
    const PlacedPair pair = resting(hull, other, source);
    ASSERT_EQ(broken_law(pair, {.directions = 300}, counts), "") << text_of(pair);
  }
  EXPECT_GT(counts.hits, 1500u);
}

// Of a mesh, too, that a hull lies on.
TEST(SpecialPoses, ContactsOfUnevenHullsWithMeshesStandOnThem) {
  tests::PairLawCounts counts;
  RandomSource source(92);
  for (int n = 0; n < 500; ++n) {
    const auto kind = static_cast<std::size_t>(n);
    const Shape hull = uneven_hull(kind, std::pow(10.0, source.uniform(-12, -5)), source);
    const PlacedPair pair = resting(hull, tests::plain_shape(ShapeKind::Mesh, kind), source);
    ASSERT_EQ(broken_law(pair, {.directions = 300}, counts), "") << text_of(pair);
  }
}

}  // namespace
}  // namespace graze
