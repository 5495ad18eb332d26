// Law 15 with a margin, from step to step: what lies and trembles keeps its contacts while it
// touches, is apart by less than the margin, or does both by turns.

#include <graze/engine/world/manifold.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "tests/engine/way_out/tessellated.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

constexpr double kMargin = 0.002;  // metres
constexpr double kTremble = 1e-6;  // metres and radians of each step

struct LyingBody {
  const char* name;
  Shape shape;
  double half;  ///< metres, of its height
};

std::vector<LyingBody> lying_bodies() {
  const Vector3d half(0.25, 0.25, 0.15);
  const std::vector<tests::ProfilePoint> profile = {
      {0, -0.15}, {0.25, -0.15}, {0.25, 0.15}, {0, 0.15}};
  const Mesh prism = tests::turned_profile(profile, 7, {1, 1});
  return {{"box", Box{half}, half.z()},
          {"hull", ConvexHull(prism.vertices()), 0.15},
          {"mesh of a box", tests::tessellated_box(half, 1), half.z()},
          {"fine mesh of a box", tests::tessellated_box(half, 5), half.z()},
          {"mesh of a prism", prism, 0.15},
          {"mesh of a drum", tests::turned_profile(profile, 24, {1, 1}), 0.15}};
}

/// How the upper one of two bodies of a kind lies on the lower one, but for trembling.
struct LaidBody {
  double gap;   ///< metres
  double lean;  ///< radians
  Pose pose;
};

LaidBody drawn(const LyingBody& body, int n, RandomSource& source) {
  LaidBody lying{.gap = (n % 3 - 1) * 5e-4,
                 .lean = n % 2 == 0 ? 0 : std::pow(10, source.uniform(-6, -3)),
                 .pose = Pose::Identity()};
  const double turn = source.uniform(-0.3, 0.3);
  const Vector3d about = Vector3d{source.uniform(-1, 1), source.uniform(-1, 1), 0}.normalized();
  lying.pose.translation() =
      Vector3d{source.uniform(-0.01, 0.01), source.uniform(-0.01, 0.01), 2 * body.half + lying.gap};
  lying.pose.linear() =
      (AngleAxisd(lying.lean, about) * AngleAxisd(turn, Vector3d::UnitZ())).toRotationMatrix();
  return lying;
}

Pose trembling(const Pose& pose, RandomSource& source) {
  const Vector3d by = kTremble * source.vector(-1, 1), turn = kTremble * source.vector(-1, 1);
  Pose moved = pose;
  moved.linear() = AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * pose.linear();
  moved.translation() += by;
  return moved;
}

struct Kept {
  int asked = 0, kept = 0;
};

/// Counts the contacts that are there in the next step as well, and holds them to law 15.
void follow(const LyingBody& body, const LaidBody& lying, RandomSource& source, Kept& kept) {
  std::map<ContactFeature, ShapeContact> last;
  for (int step = 0; step < 20; ++step) {
    const Pose pose = trembling(lying.pose, source);
    const Manifold found =
        find_contacts({body.shape}, {body.shape, pose}, ManifoldSettings{.margin = kMargin});
    ASSERT_EQ(found.region_count(), 1u) << "gap " << lying.gap << ", lean " << lying.lean;
    std::map<ContactFeature, ShapeContact> now;
    for (const ShapeContact& contact : found) {
      EXPECT_TRUE(now.emplace(contact.feature, contact).second) << "two of one name";
      const auto before = last.find(contact.feature);
      if (before == last.end()) continue;
      ++kept.kept;
      // No point moved by more than 2e-6 of either step, on a body of about half a metre.
      EXPECT_NEAR(contact.depth, before->second.depth, 8e-6);
    }
    kept.asked += static_cast<int>(last.size());
    last = std::move(now);
  }
}

TEST(Margin, Law15WhatLiesAndTremblesKeepsItsContacts) {
  for (const LyingBody& body : lying_bodies()) {
    SCOPED_TRACE(body.name);
    RandomSource source(1507);
    Kept kept;
    for (int n = 0; n < 60 && !testing::Test::HasFailure(); ++n)
      follow(body, drawn(body, n, source), source, kept);
    EXPECT_GT(kept.asked, 4000);
    EXPECT_GE(kept.kept, 0.99 * kept.asked);
  }
}

// Where the two miss each other by less than tells a direction, their faces do: else the nearest
// points were the one contact.
TEST(Margin, Law15WhatAllButTouchesHasAllItsContacts) {
  const Vector3d half(0.25, 0.25, 0.15);
  const Shape body = tests::tessellated_box(half, 1);
  RandomSource source(1508);
  for (int n = 0; n < 2000; ++n) {
    Pose laid = Pose::Identity();
    const double turn = source.uniform(-0.3, 0.3);
    laid.linear() = AngleAxisd(turn, Vector3d::UnitZ()).toRotationMatrix();
    laid.translation() = Vector3d{source.uniform(-0.01, 0.01), source.uniform(-0.01, 0.01), 0.3};
    const Manifold found =
        find_contacts({body}, {body, trembling(laid, source)}, ManifoldSettings{.margin = kMargin});
    ASSERT_EQ(found.size(), 4u) << n;
    ASSERT_EQ(found.region_count(), 1u) << n;
  }
}

}  // namespace
}  // namespace graze
