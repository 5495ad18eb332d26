// Shapes along the same axes, at right angles, concentric, equal and just touching: every promise
// about a pair, of every pair of kinds, against oracles that share nothing with the solvers.

#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/engine/special_poses/pair_laws.h"
#include "tests/engine/special_poses/pair_text.h"
#include "tests/engine/special_poses/special_pairs.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/shape_kinds.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::kConvexKinds;
using tests::PairLawCounts;
using tests::PlacedPair;
using tests::SpecialPlace;

/// Every pair of convex kinds under every right turn, once for each place and each shape.
template <typename OnPair>
void for_each_special(std::size_t shapes, OnPair&& on_pair) {
  for (std::size_t i = 0; i < kConvexKinds; ++i) {
    for (std::size_t j = i; j < kConvexKinds; ++j) {
      for (std::size_t turn = 0; turn < tests::kRightTurns; ++turn) {
        for (const SpecialPlace place :
             {SpecialPlace::Concentric, SpecialPlace::Offset, SpecialPlace::Touching}) {
          for (std::size_t n = 0; n < shapes; ++n) {
            const std::size_t index = turn + 31 * n + 5 * i + 11 * j;
            on_pair(special_pair(tests::kOwnKinds[i], tests::kOwnKinds[j], turn, place, index));
          }
        }
      }
    }
  }
}

void expect_kept(const PlacedPair& pair, PairLawCounts& counts) {
  const std::string broken = broken_law(pair, {.directions = 300}, counts);
  EXPECT_EQ(broken, "") << text_of(pair);
}

TEST(SpecialPoses, KeepEveryPromise) {
  PairLawCounts counts;
  for_each_special(1, [&](const PlacedPair& pair) {
    if (!testing::Test::HasFailure()) expect_kept(pair, counts);
  });
  EXPECT_EQ(counts.pairs, 28u * 24 * 3);
  EXPECT_GT(counts.depths, counts.hits * 9 / 10);
  EXPECT_LE(counts.unconverged, 2u);
  RecordProperty("hits", static_cast<int>(counts.hits));
  RecordProperty("unproved", static_cast<int>(counts.unproved));
}

TEST(SpecialPoses, DrawnAtRandomKeepEveryPromise) {
  PairLawCounts counts;
  RandomSource source(71);
  for (int n = 0; n < 2000 && !HasFailure(); ++n)
    expect_kept(tests::drawn_pair(source), counts);
  EXPECT_LE(counts.unconverged, 2u);
  EXPECT_GT(counts.depths, 700u);
  EXPECT_GT(counts.pairs - counts.hits, 200u);
}

Pose at(double x, double y, double z) {
  Pose pose = Pose::Identity();
  pose.translation() = Vector3d(x, y, z);
  return pose;
}

/// With the shape's axis along x.
Pose lying(double x, double y, double z) {
  Pose pose = at(x, y, z);
  pose.linear() << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  return pose;
}

Eigen::AngleAxisd right_turn_about_x() {
  return Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitX());
}

double depth_of(const PlacedPair& pair, Work* work = nullptr) {
  const Manifold found = find_contacts({pair.a, pair.pose_a}, {pair.b, pair.pose_b}, work);
  return found.empty() ? 0 : found[0].depth;
}

/// By how much the two reach past each other along the normal of their contacts.
double width_of(const PlacedPair& pair, Work* work) {
  const Manifold found = find_contacts({pair.a, pair.pose_a}, {pair.b, pair.pose_b}, work);
  return found.empty() ? 0 : std::max(width_along(pair, found[0].normal), 0.0);
}

// What the depth of cones at right angles to their partner once was: the height or the diameter.
TEST(SpecialPoses, ConesAtRightAnglesPartByTheirSides) {
  const double root = std::sqrt(5.0);
  const Shape cone = Cone{1, 1};
  const auto expect_depth = [](const PlacedPair& pair, double expected) {
    Work work;
    EXPECT_NEAR(depth_of(pair, &work), expected, 2e-6) << text_of(pair);
    EXPECT_EQ(work.penetration_failures, 0u) << text_of(pair);
  };
  // Along the normal (2 sin(t), 1) / root of a side: the cone reaches 1 / root.
  const PlacedPair of_cylinder{Cylinder{1, 1}, cone, at(0, 0, 0), lying(0, 0, 0)};
  expect_depth(of_cylinder, least_width(of_cylinder, 5000).width);
  EXPECT_LT(depth_of(of_cylinder), 1.4473);
  const PlacedPair of_capsule{Capsule{1, 1}, cone, at(0, 0, 0), lying(0, 0, 0)};
  expect_depth(of_capsule, least_width(of_capsule, 5000).width);
  EXPECT_LT(depth_of(of_capsule), 1.4473);
  const PlacedPair of_cones{cone, cone, at(0, 0, 0), lying(0, 0, 0)};
  expect_depth(of_cones, least_width(of_cones, 5000).width);
  EXPECT_LE(depth_of(of_cones), 4 / root + 2e-6);
}

// Rounding tears their polytopes at once. What was taken then was up to a fifth of the smaller size
// more than the least.
TEST(SpecialPoses, DepthsThatAreNotProvedAreNearTheLeast) {
  const auto hull = [](std::size_t n) { return tests::plain_shape(ShapeKind::ConvexHull, n); };
  const Shape shapes[] = {hull(0),      hull(1),        hull(5),       hull(20),
                          Cone{1, 0.5}, Cone{0.7, 0.6}, Cylinder{1, 1}};
  PairLawCounts counts;
  RandomSource source(81);
  for (int n = 0; n < 3000; ++n) {
    PlacedPair pair{shapes[n % 7], shapes[n / 7 % 7], at(0, 0, 0), at(0, 0, 0)};
    const Eigen::AngleAxisd tilt{std::pow(10.0, source.uniform(-15, -12)),
                                 source.vector(-1, 1).normalized()};
    pair.pose_b.linear() =
        tilt * tests::right_turn(static_cast<std::size_t>(n / 49) % tests::kRightTurns);
    expect_kept(pair, counts);
  }
  EXPECT_LT(counts.worst_unproved, 1e-3);
  EXPECT_GT(counts.depths, 2000u);
}

TEST(SpecialPoses, DepthsAreContinuous) {
  constexpr double kMotion = 1e-9;
  RandomSource source(73);
  int moved = 0;
  const auto expect_continuous = [&](const PlacedPair& pair) {
    if (pair.a.kind() == ShapeKind::Box && pair.b.kind() == ShapeKind::Box) return;
    Work before_work, after_work;
    const double before = width_of(pair, &before_work);
    PlacedPair other = pair;
    other.pose_b.translation() += source.vector(-1, 1).normalized() * kMotion;
    const double after = width_of(other, &after_work);
    if (before_work.penetration_failures + after_work.penetration_failures > 0) return;
    ++moved;
    const double size =
        std::min(tests::size_about_middle(pair.a), tests::size_about_middle(pair.b));
    const double most = kMotion + 1e-6 * size + kTouchTolerance * scale_of(pair);
    EXPECT_LE(std::abs(after - before), most) << text_of(pair);
  };
  for_each_special(1, [&](const PlacedPair& pair) { expect_continuous(pair); });
  EXPECT_GT(moved, 1500);
}

// Half-spaces: the depth is that of the lowest point, whatever the shape.
TEST(SpecialPoses, DepthsInHalfSpacesAreThoseOfTheLowestPoint) {
  for (std::size_t i = 0; i < kConvexKinds; ++i) {
    for (std::size_t turn = 0; turn < tests::kRightTurns; ++turn) {
      PlacedPair pair =
          special_pair(tests::kOwnKinds[i], tests::kOwnKinds[i], turn, SpecialPlace::Offset, turn);
      pair.a = HalfSpace{{0, 0, 1}, 0};
      const double expected = std::max(width_along(pair, Vector3d(0, 0, 1)), 0.0);
      EXPECT_NEAR(depth_of(pair), expected, 1e-14) << text_of(pair);
    }
  }
}

// No rule could tell A from B: the swapped question is the same one.
TEST(SpecialPoses, EqualShapesInEqualPosesHaveOneAnswer) {
  PairLawCounts counts;
  for (const ShapeKind kind : tests::kOwnKinds) {
    if (kind == ShapeKind::HalfSpace || kind == ShapeKind::Mesh) continue;
    for (std::size_t turn = 0; turn < tests::kRightTurns; ++turn) {
      PlacedPair pair = special_pair(kind, kind, turn, SpecialPlace::Offset, 7 * turn);
      pair.a = pair.b;
      pair.pose_a = pair.pose_b;
      expect_kept(pair, counts);
      // A zero of another sign is another pose, so that there is something to mirror.
      pair.pose_a.linear() += Eigen::Matrix3d::Zero();
      pair.pose_b.linear() = -(-pair.pose_a.linear() + Eigen::Matrix3d::Zero());
      expect_kept(pair, counts);
    }
  }
}

// The ways between their axes are off by rounding over 3.5e-7, planes must not be.
TEST(SpecialPoses, ThinCapsulesThatNearlyTouchHavePlanesAsFarApartAsTheirBound) {
  PairLawCounts counts;
  RandomSource source(74);
  for (int n = 0; n < 3000; ++n) {
    PlacedPair pair{Capsule{1e-9, 1}, Capsule{1e-9, 0.7}, at(0, 0, 0), at(0, 0, 0)};
    const double angle = n % 3 == 0 ? 0 : std::pow(10.0, source.uniform(-14, 0));
    pair.pose_b.rotate(Eigen::AngleAxisd(angle, Vector3d::UnitX()));
    pair.pose_b.translation() =
        Vector3d{std::pow(10.0, source.uniform(-8, -2)), 0, source.uniform(-1.5, 1.5)};
    const Eigen::Matrix3d turn = tests::random_pose(1, source).linear();
    pair.pose_a.prerotate(turn);
    pair.pose_b.prerotate(turn);
    expect_kept(pair, counts);
  }
  EXPECT_EQ(counts.unconverged, 0u);
}

// Their axes pass by each other at 1e-5 of their length, at 3e-6 of an angle: less than the way
// between the nearest points of either can tell, and no axes that meet.
TEST(SpecialPoses, CapsulesWhoseAxesNearlyMeetPartByTheirAxes) {
  Pose first, second;
  first.matrix() << 0.78996858295500849, -0.096171323396700453, 0.60555818424011276, 0,
      -0.36153809757984268, -0.87072719935884235, 0.33335318851790646, 0, 0.49521696451394237,
      -0.48227089986109878, -0.72261672912046715, 0, 0, 0, 0, 1;
  second.matrix() << 0.096171507833465134, -0.78997135910224714, -0.60555453336523346,
      0.75694773030014095, 0.87072224602239812, 0.361541759791978, -0.33336215473300179,
      0.41669148564738306, 0.4822798060905597, -0.4952098623055356, 0.72261565227483449,
      -0.90327091140058391, 0, 0, 0, 1;
  PairLawCounts counts;
  expect_kept({Capsule{1, 0.25}, Capsule{1, 1}, first, second}, counts);
  EXPECT_EQ(counts.unproved, 0u);
  RandomSource source(76);
  for (int n = 0; n < 2000; ++n) {
    PlacedPair pair{Capsule{1, 0.5}, Capsule{0.7, 1}, at(0, 0, 0), at(0, 0, 0)};
    pair.pose_b.rotate(
        Eigen::AngleAxisd(std::pow(10.0, source.uniform(-8, -2)), Vector3d::UnitX()));
    pair.pose_b.translation() =
        Vector3d{std::pow(10.0, source.uniform(-9, -2)), 0, source.uniform(-1.4, 1.4)};
    const Eigen::Matrix3d turn = tests::random_pose(1, source).linear();
    pair.pose_a.prerotate(turn);
    pair.pose_b.prerotate(turn);
    expect_kept(pair, counts);
  }
}

TEST(SpecialPoses, PairsThatOnceBrokeAPromiseKeepEveryOne) {
  std::ifstream file(std::filesystem::path(GRAZE_DATA_DIR) / "regressions/shape_pairs.txt");
  PairLawCounts counts;
  while (const std::optional<PlacedPair> pair = tests::read_pair(file)) {
    expect_kept(*pair, counts);
    // A length of every shape must stay one that shapes may have.
    if (scale_of(*pair) > 1e3 || smaller_size(*pair) < 1e-3) continue;
    for (const double factor : {0x1p-310, 0x1p310})
      EXPECT_EQ(broken_scaling(*pair, factor), "") << text_of(*pair);
  }
  EXPECT_GE(counts.pairs, 26u);
  // Of what is lost in the rounding of a cone, a hull or a box, and of two that their boxes part.
  EXPECT_LE(counts.unconverged, 9u);
}

/// One pose's axis along the other's, turned about it, apart by `gap` along a direction across it.
PlacedPair beside(const Shape& a, const Shape& b, double gap, RandomSource& source) {
  PlacedPair pair{a, b, at(0, 0, 0), at(0, 0, source.integer(-1, 1) * 5)};
  pair.pose_b.rotate(Eigen::AngleAxisd(source.uniform(0, 7), Vector3d::UnitZ()));
  if (source.integer(0, 1) == 1) pair.pose_b.rotate(right_turn_about_x());
  const double angle = source.uniform(0, 7);
  const Vector3d across(std::cos(angle), std::sin(angle), 0);
  pair.pose_b.translation() += across * width_along(pair, across);
  const tests::LeastWidth least = tests::least_width(pair, 200);
  pair.pose_b.translation() += least.direction * (least.width + gap);
  const Eigen::Matrix3d turn = tests::random_pose(1, source).linear();
  pair.pose_a.prerotate(turn);
  pair.pose_b.prerotate(turn);
  return pair;
}

// Edges, sides and rims beside each other: nearest points are many, and searches once ended open,
// with a hit, at gaps of a millionth.
TEST(SpecialPoses, ShapesBesideEachOtherAreKnownToTheirTolerance) {
  PairLawCounts counts;
  RandomSource source(79);
  const Shape shapes[] = {Box{{5, 4, 5}}, Cone{5, 5}, Cylinder{5, 5},
                          tests::plain_shape(ShapeKind::ConvexHull, 0)};
  int hits = 0;
  constexpr int kPairs = 3000;
  for (int n = 0; n < kPairs; ++n) {
    const double gap = std::pow(10.0, source.uniform(-8, -1));
    const PlacedPair pair = beside(shapes[n % 4], shapes[n / 4 % 4], gap, source);
    expect_kept(pair, counts);
    hits += intersects({pair.a, pair.pose_a}, {pair.b, pair.pose_b});
  }
  EXPECT_LT(counts.unconverged, kPairs / 200u);
  EXPECT_LT(hits, kPairs / 500);
}

// Cones and ellipsoids so flat that a tetrahedron of their points may be rounding alone.
TEST(SpecialPoses, FlatShapesThatAllButTouchAreApartOrNot) {
  PairLawCounts counts;
  RandomSource source(77);
  for (int n = 0; n < 3000; ++n) {
    const double flat = std::pow(10.0, source.uniform(-3, -0.5));
    PlacedPair pair{Ellipsoid{{0, 0, 0}, {1, 1, flat}}, Cone{source.uniform(0.3, 1), flat},
                    at(0, 0, 0), at(0, 0, 0)};
    pair.pose_b.linear() = tests::right_turn(static_cast<std::size_t>(n) % tests::kRightTurns);
    pair.pose_b.translation() = source.vector(-1, 1);
    const tests::LeastWidth least = tests::least_width(pair, 200);
    pair.pose_b.translation() +=
        least.direction * (least.width + std::pow(10.0, source.uniform(-15, -6)));
    expect_kept(pair, counts);
  }
  EXPECT_GT(counts.pairs - counts.hits, 1000u);
}

// Caps that lie on faces with a tilt of next to nothing: which of their corners are the deepest is
// a tie that no tolerance may settle at the price of the promised depth.
TEST(SpecialPoses, ContactsOfNearlyAlignedCapsAreAsDeepAsTheirWidth) {
  PairLawCounts counts;
  RandomSource source(78);
  const Shape round[] = {Cylinder{0.9, 0.3}, Cylinder{0.25, 1}, Cone{1, 0.5}};
  const Shape others[] = {Cylinder{0.9, 0.3}, Box{{0.9, 0.7, 0.3}}, Cone{0.5, 0.75}};
  for (int n = 0; n < 2000; ++n) {
    PlacedPair pair{round[n % 3], others[n / 3 % 3], at(0, 0, 0), at(0, 0, 0)};
    const Eigen::AngleAxisd tilt{std::pow(10.0, source.uniform(-5, -2)),
                                 source.vector(-1, 1).normalized()};
    pair.pose_b.linear() =
        tilt * tests::right_turn(static_cast<std::size_t>(n) % tests::kRightTurns);
    pair.pose_b.translation() = source.vector(-1, 1) * (n % 2 == 0 ? 0 : 0.2);
    expect_kept(pair, counts);
  }
  EXPECT_GT(counts.depths, 1000u);
}

TEST(SpecialPosesSlow, DrawnAtRandomKeepEveryPromise) {
  PairLawCounts counts;
  RandomSource source(72);
  for (int n = 0; n < 300000 && !HasFailure(); ++n)
    expect_kept(tests::drawn_pair(source), counts);
}

}  // namespace
}  // namespace graze
