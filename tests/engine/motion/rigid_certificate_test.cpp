// Law 14, certificates: those of free motions are accepted, and what proves nothing is refused.

#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/rigid_certificate.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

/// A rod that turns in a ring without touching it.
struct TurningRod {
  Mesh ring = tests::make_torus(1, 0.25, 24, 12);
  Mesh rod = tests::make_box({0.5, 0.25, 0.125});
  RigidMotion rest = RigidMotion(Pose::Identity());
  RigidMotion motion =
      RigidMotion(Pose::Identity(), {.shift = {0.03, 0.02, 0.1}, .axis = {0, 1, 9}, .angle = 7});

  bool is_proved_by(const FreedomCertificate& certificate) const {
    return proves_freedom(certificate, {ring, rest}, {rod, motion});
  }
};

TEST(Law14Certificate, FreeMotionsHaveOneThatIsAccepted) {
  RandomSource source(1430);
  int accepted = 0;
  for (int i = 0; i < 100; ++i) {
    const Mesh a = tests::random_soup({.count = 12, .extent = 0.5}, source);
    const Mesh b = i % 2 == 0 ? tests::make_box({0.1, 0.25, 0.125})
                              : tests::random_soup({.count = 9, .extent = 0.5}, source);
    const Pose start_a = tests::random_pose(1, source), start_b = tests::random_pose(1.5, source);
    const RigidMotion motion_a(start_a, {.shift = source.vector(-1, 1), .angle = i % 3 * 1.0});
    const Pose end_b = tests::random_pose(1.5, source);
    const RigidMotion motion_b = RigidMotion::between(start_b, end_b, source.vector(-1, 1));
    const RigidContactSettings settings{.clearance = i % 4 * 0.01};
    const auto certificate = certify_free({a, motion_a}, {b, motion_b}, settings);
    EXPECT_EQ(certificate.has_value(), is_free({a, motion_a}, {b, motion_b}, settings));
    if (!certificate) continue;
    EXPECT_TRUE(proves_freedom(*certificate, {a, motion_a}, {b, motion_b}));
    ++accepted;
  }
  EXPECT_GT(accepted, 20);
}

TEST(Law14Certificate, WithoutAStepOrWithAnotherPlaneItIsRefused) {
  const TurningRod scene;
  const auto certificate = certify_free({scene.ring, scene.rest}, {scene.rod, scene.motion});
  ASSERT_TRUE(certificate);
  ASSERT_TRUE(scene.is_proved_by(*certificate));
  const std::size_t step = std::max<std::size_t>(1, certificate->steps.size() / 40);
  for (std::size_t i = 0; i < certificate->steps.size(); i += step) {
    FreedomCertificate without = *certificate;
    without.steps.erase(without.steps.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(scene.is_proved_by(without)) << i;
    if (certificate->steps[i].kind != FreedomStep::Kind::Plane) continue;
    FreedomCertificate turned = *certificate;
    turned.steps[i].normal = -turned.steps[i].normal;
    EXPECT_FALSE(scene.is_proved_by(turned)) << i;
    turned.steps[i].normal = {0, 0, 0};
    EXPECT_FALSE(scene.is_proved_by(turned)) << i;
    turned.steps[i].normal = {std::nan(""), 1, 0};
    EXPECT_FALSE(scene.is_proved_by(turned)) << i;
    turned.steps[i].normal = 1000 * certificate->steps[i].normal;
    EXPECT_TRUE(scene.is_proved_by(turned)) << i;
  }
}

TEST(Law14Certificate, WhatIsBrokenIsRefused) {
  const TurningRod scene;
  const auto certificate = certify_free({scene.ring, scene.rest}, {scene.rod, scene.motion});
  ASSERT_TRUE(certificate);
  const auto is_refused = [&](const auto& breaks) {
    FreedomCertificate broken = *certificate;
    breaks(broken);
    return !scene.is_proved_by(broken);
  };
  EXPECT_TRUE(is_refused([](auto& c) { c.steps.clear(); }));
  EXPECT_TRUE(is_refused([](auto& c) { c.steps.push_back(c.steps.back()); }));
  EXPECT_TRUE(is_refused([](auto& c) { c.order_a.pop_back(); }));
  EXPECT_TRUE(is_refused([](auto& c) { c.order_b.push_back(0); }));
  EXPECT_TRUE(is_refused([](auto& c) { c.order_a[0] = c.order_a[1]; }));
  EXPECT_TRUE(is_refused([](auto& c) { c.order_b[0] = 1u << 31; }));
  EXPECT_TRUE(is_refused([](auto& c) { c.clearance = 0.5; }));
  EXPECT_TRUE(is_refused([](auto& c) { c.clearance = -1; }));
  EXPECT_TRUE(is_refused([](auto& c) { c.clearance = std::nan(""); }));
  EXPECT_TRUE(is_refused([](auto& c) { c.steps[0].kind = static_cast<FreedomStep::Kind>(77); }));
  for (const auto kind : {FreedomStep::Kind::DivideA, FreedomStep::Kind::DivideB}) {
    EXPECT_TRUE(is_refused([&](auto& c) { c.steps[0] = {kind, 0, {0, 0, 0}}; }));
    EXPECT_TRUE(is_refused([&](auto& c) { c.steps[0] = {kind, 1u << 31, {0, 0, 0}}; }));
  }
  EXPECT_TRUE(is_refused([](auto& c) {
    c.steps.assign(2000, {FreedomStep::Kind::HalveTime, 0, {0, 0, 0}});
  }));
}

/// Nothing that is accepted may hit: certificates are tried on motions and meshes that are not
/// theirs.
TEST(Law14Certificate, OfAnotherMotionOrMeshItProvesWhatItAcceptsOrIsRefused) {
  const TurningRod scene;
  const auto certificate = certify_free({scene.ring, scene.rest}, {scene.rod, scene.motion});
  ASSERT_TRUE(certificate);
  RandomSource source(1431);
  int refused = 0;
  for (int i = 0; i < 200; ++i) {
    const double reach = std::pow(10, -source.uniform(0, 5));
    RigidCourse course{.centre = scene.motion.centre() + reach * source.vector(-1, 1),
                       .shift = scene.motion.shift() + reach * source.vector(-1, 1),
                       .axis = scene.motion.axis() + reach * source.vector(-1, 1),
                       .angle = scene.motion.angle() + reach * source.uniform(-1, 1)};
    const RigidMotion other(tests::at(reach * source.uniform(-1, 1)), course);
    if (!proves_freedom(*certificate, {scene.ring, scene.rest}, {scene.rod, other})) {
      ++refused;
      continue;
    }
    for (int k = 0; k <= 50; ++k)
      EXPECT_FALSE(intersects({scene.ring}, {scene.rod, other.at(k / 50.0)}));
  }
  EXPECT_GT(refused, 50);
  EXPECT_LT(refused, 200);
  // At the start all are where the certificate has them.
  const Mesh box = tests::make_box({0.5, 0.5, 0.5});
  const RigidMotion apart(tests::at(3));
  const auto at_rest = certify_free({box, scene.rest}, {box, apart});
  ASSERT_TRUE(at_rest && proves_freedom(*at_rest, {box, scene.rest}, {box, apart}));
  const RigidMotion comes(tests::at(3), {.shift = {-3, 0, 0}});
  EXPECT_FALSE(proves_freedom(*at_rest, {box, scene.rest}, {box, comes}));
  const RigidMotion turns(tests::at(3), {.angle = std::acos(-1)});
  EXPECT_FALSE(proves_freedom(*at_rest, {box, scene.rest}, {box, turns}));
  const Mesh longer = tests::make_box({0.75, 0.25, 0.125});
  EXPECT_FALSE(proves_freedom(*certificate, {scene.ring, scene.rest}, {longer, scene.motion}));
  EXPECT_FALSE(proves_freedom(*certificate, {scene.rod, scene.rest}, {scene.ring, scene.motion}));
}

}  // namespace
}  // namespace graze
