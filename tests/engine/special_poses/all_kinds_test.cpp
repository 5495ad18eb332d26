// Special pairs of all kinds, half-spaces and meshes among them, and at the scales of atoms and of
// galaxies.

#include <graze/bvh/error.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/engine/special_poses/pair_laws.h"
#include "tests/engine/special_poses/pair_text.h"
#include "tests/engine/special_poses/special_pairs.h"
#include "tests/shapes/shape_kinds.h"

namespace graze {
namespace {

using tests::PairLawCounts;
using tests::PlacedPair;
using tests::SpecialPlace;

/// Every pair of kinds but two half-spaces, A and B in either order, under so many right turns.
template <typename OnPair>
void for_each_pair_of_kinds(std::size_t turns, OnPair&& on_pair) {
  std::size_t index = 0;
  for (const ShapeKind kind_a : tests::kOwnKinds) {
    for (const ShapeKind kind_b : tests::kOwnKinds) {
      if (kind_a == ShapeKind::HalfSpace && kind_b == kind_a) continue;
      for (std::size_t n = 0; n < turns; ++n) {
        for (const SpecialPlace place :
             {SpecialPlace::Concentric, SpecialPlace::Offset, SpecialPlace::Touching}) {
          ++index;
          on_pair(special_pair(kind_a, kind_b, (n * 7 + index) % tests::kRightTurns, place, index));
        }
      }
    }
  }
}

TEST(AllKinds, KeepEveryPromise) {
  PairLawCounts counts;
  for_each_pair_of_kinds(tests::kRightTurns, [&](const PlacedPair& pair) {
    if (HasFailure()) return;
    EXPECT_EQ(broken_law(pair, {.directions = 200}, counts), "") << text_of(pair);
  });
  EXPECT_EQ(counts.pairs, 80u * 24 * 3);
  EXPECT_EQ(counts.surfaces, 17u * 24 * 3);
  EXPECT_GT(counts.depths, 3000u);
  EXPECT_LE(counts.unconverged, 4u);
}

TEST(AllKinds, DrawnAtRandomKeepEveryPromise) {
  PairLawCounts counts;
  RandomSource source(192);
  for (int n = 0; n < 3000 && !HasFailure(); ++n) {
    const PlacedPair pair = tests::drawn_pair(source, tests::kOwnKinds.size());
    EXPECT_EQ(broken_law(pair, {.directions = 200}, counts), "") << text_of(pair);
  }
  EXPECT_GT(counts.surfaces, 500u);
  EXPECT_GT(counts.depths, 1000u);
}

TEST(AllKindsSlow, DrawnAtRandomKeepEveryPromise) {
  PairLawCounts counts;
  RandomSource source(193);
  for (int n = 0; n < 200000 && !HasFailure(); ++n) {
    const PlacedPair pair = tests::drawn_pair(source, tests::kOwnKinds.size());
    EXPECT_EQ(broken_law(pair, {}, counts), "") << text_of(pair);
    EXPECT_EQ(broken_scaling(pair, n % 2 == 0 ? 0x1p-310 : 0x1p310), "") << text_of(pair);
  }
}

// About 1e-93, 1e-8, 1e8 and 1e93: what is true at one scale is so at all.
TEST(AllKinds, AnswerTheSameAtEveryScale) {
  for_each_pair_of_kinds(4, [&](const PlacedPair& pair) {
    if (HasFailure()) return;
    for (const double factor : {0x1p-310, 0x1p-27, 0x1p27, 0x1p310})
      EXPECT_EQ(broken_scaling(pair, factor), "") << factor << "\n" << text_of(pair);
  });
}

// Beyond kSmallestLength and kLargestLength there are no shapes.
TEST(AllKinds, ScalesBeyondAllLengthsAreRefused) {
  std::size_t refused = 0;
  for_each_pair_of_kinds(1, [&](const PlacedPair& pair) {
    const auto is_unbounded = [](const Shape& shape) {
      return shape.kind() == ShapeKind::HalfSpace || shape.kind() == ShapeKind::Mesh;
    };
    if (is_unbounded(pair.a) && is_unbounded(pair.b)) return;
    for (const double factor : {0x1p-498, 0x1p498}) {  // 1e-150 and 1e150
      EXPECT_THROW(scaled(pair, factor), Error) << text_of(pair);
      ++refused;
    }
  });
  EXPECT_EQ(refused, 77u * 3 * 2);
}

// Two half-spaces meet unless their normals are opposite, and then by their offsets alone.
TEST(AllKinds, TwoHalfSpacesAreApartOnlyBackToBack) {
  for (std::size_t turn = 0; turn < tests::kRightTurns; ++turn) {
    const Shape plane = HalfSpace{{0, 0, 1}, 0};
    Pose pose = Pose::Identity();
    pose.linear() = tests::right_turn(turn);
    const bool is_opposite = pose.linear()(2, 2) == -1;
    for (const double height : {-1.0, 0.0, 0x1p-40, 1.0}) {
      pose.translation() = Eigen::Vector3d(0, 0, height);
      const bool is_apart = is_opposite && height > 0;
      EXPECT_EQ(intersects({plane}, {plane, pose}), !is_apart) << turn << " " << height;
      EXPECT_EQ(intersects({plane, pose}, {plane}), !is_apart) << turn << " " << height;
      EXPECT_EQ(distance({plane}, {plane, pose}).distance, is_apart ? height : 0);
      EXPECT_EQ(distance({plane, pose}, {plane}).distance, is_apart ? height : 0);
      if (is_apart) {
        EXPECT_TRUE(find_contacts({plane}, {plane, pose}).empty());
      } else {
        EXPECT_THROW(find_contacts({plane}, {plane, pose}), UnsupportedPairError);
      }
    }
  }
}

}  // namespace
}  // namespace graze
