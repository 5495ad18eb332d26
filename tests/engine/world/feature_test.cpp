// Features of what stands on each other stay the same while it jitters: above all where corners and
// edges of the two coincide, as in every stack of equal parts, so that each jitter would cut them
// in another way.

#include <graze/engine/world/manifold.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::at;

/// Moved and turned by up to so much, metres and radians.
Pose jittered(const Pose& pose, double size, RandomSource& source) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd{source.uniform(-size, size), source.vector(-1, 1).normalized()}
          .toRotationMatrix();
  Pose next = pose;
  next.linear() = turn * pose.linear();
  next.translation() += source.vector(-size, size);
  return next;
}

std::set<ContactFeature> features_of(const Manifold& manifold) {
  std::set<ContactFeature> features;
  for (const ShapeContact& contact : manifold)
    features.insert(contact.feature);
  return features;
}

/// Which share of the contacts was there a step before, by feature, if both jitter.
double kept_share(const Shape& lower, const Shape& upper, const Pose& pose, double jitter) {
  RandomSource source(31);
  std::set<ContactFeature> before;
  std::size_t kept = 0, all = 0;
  for (int step = 0; step < 400; ++step) {
    const Pose below = jittered(at(0), jitter, source), above = jittered(pose, jitter, source);
    const Manifold m = find_contacts({lower, below}, {upper, above});
    EXPECT_FALSE(m.empty());
    const std::set<ContactFeature> now = features_of(m);
    EXPECT_EQ(now.size(), m.size());
    if (step > 0) {
      all += m.size();
      for (const ContactFeature& feature : now)
        kept += before.contains(feature);
    }
    before = now;
  }
  return static_cast<double>(kept) / static_cast<double>(all);
}

constexpr double kJitters[] = {1e-9, 1e-7, 1e-5, 1e-4};

struct Stack {
  const char* name;
  Shape lower, upper;
  Pose pose;     // of the upper one
  double least;  // share of features that are kept
};

/// What slides back onto an edge stays where the two meet: on both, and as deep as it is there.
TEST(Features, OfCoincidingEdgesLieOnBoth) {
  RandomSource source(32);
  const Box box{{0.5, 0.5, 0.5}};
  for (int n = 0; n < 300; ++n) {
    const double jitter = 3e-3 * source.uniform(0, 1) * source.uniform(0, 1);
    const Pose lower = jittered(at(0), jitter, source);
    const Pose upper = jittered(at(0, 0, 0.99), jitter, source);
    const Manifold m = find_contacts({box, lower}, {box, upper});
    ASSERT_EQ(m.size(), 4u);
    for (const ShapeContact& contact : m) {
      const Vector3d in_lower = lower.inverse() * contact.point;
      const Vector3d in_upper = upper.inverse() * contact.point;
      // Turned by so much, a corner is off by its square, and midway by a share of the depth.
      const double off = 0.5 + 8 * jitter * jitter + 0.02 * jitter + 1e-12;
      EXPECT_LE(in_lower.cwiseAbs().maxCoeff(), off);
      EXPECT_LE(in_upper.cwiseAbs().maxCoeff(), off);
      EXPECT_NEAR(contact.depth, 0.5 - in_lower.z() + in_upper.z() + 0.5,
                  8 * jitter * jitter + 0.02 * jitter);
    }
  }
}

TEST(Features, OfStacksStayTheSame) {
  constexpr double kSunk = 1e-3;
  const Box box{{0.5, 0.5, 0.5}}, floor{{5, 5, 0.5}}, bar{{1.5, 0.5, 0.5}};
  const Cylinder drum{0.5, 0.5};
  const Pose on_top = at(0, 0, 1 - kSunk);
  Pose quarter = on_top;
  quarter.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  Pose aslant = on_top;
  aslant.linear() = Eigen::AngleAxisd(0.5, Vector3d::UnitZ()).toRotationMatrix();
  const std::vector<Stack> stacks{
      {"equal boxes", box, box, on_top, 0.95},
      {"equal boxes, a quarter turned", box, box, quarter, 0.95},
      {"equal boxes side by side", box, box, at(1 - kSunk, 0, 0), 0.95},
      {"equal boxes, one across", box, box, at(0.3, 0, 1 - kSunk), 0.95},
      {"equal boxes, both across", box, box, at(0.3, 0.2, 1 - kSunk), 0.95},
      {"equal boxes, one aslant", box, box, aslant, 0.95},
      {"box on a bar", bar, box, at(1, 0, 1 - kSunk), 0.95},
      {"bar on a box", box, bar, at(0.7, 0, 1 - kSunk), 0.95},
      {"bars", bar, bar, at(1, 0, 1 - kSunk), 0.95},
      {"box on a floor", floor, box, on_top, 0.95},
      {"equal drums", drum, drum, on_top, 0.95},
      {"drum on a floor", floor, drum, on_top, 0.95},
      {"cone on a floor", floor, Cone{0.5, 0.5}, on_top, 0.95},
  };
  for (const Stack& stack : stacks) {
    for (const double jitter : kJitters) {
      const double share = kept_share(stack.lower, stack.upper, stack.pose, jitter);
      EXPECT_GE(share, stack.least) << stack.name << ", jitter " << jitter;
    }
  }
}

}  // namespace
}  // namespace graze
