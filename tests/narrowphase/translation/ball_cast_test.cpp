// Law 13 of a triangle and a ball in positions of which the answer is known.

#include <graze/bvh/error.h>
#include <graze/narrowphase/cast.h>
#include <graze/narrowphase/volumes/spheres/triangle_sphere_stages.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace graze {
namespace {

constexpr CastSettings kLeft{.start = StartContact::IsLeft};

const Triangle kFloor{{0, 0, 0}, {40, 0, 0}, {0, 40, 0}};

TEST(Law13Balls, LandOnFacesEdgesAndCorners) {
  EXPECT_EQ(cast(kFloor, Sphere{{5, 5, 3}, 1}, {0, 0, -8}), (FirstContact{0.25, false}));
  EXPECT_EQ(cast(kFloor, Sphere{{5, 5, -3}, 1}, {0, 0, 8}), (FirstContact{0.25, false}));
  // Edge and corner three beside: they are met four below the centre of a ball of five.
  EXPECT_EQ(cast(kFloor, Sphere{{5, -3, 8}, 5}, {0, 0, -8}), (FirstContact{0.5, false}));
  EXPECT_EQ(cast(kFloor, Sphere{{-3, 0, 8}, 5}, {0, 0, -8}), (FirstContact{0.5, false}));
  EXPECT_FALSE(cast(kFloor, Sphere{{5, 5, 3}, 1}, {0, 0, 8}));
  EXPECT_FALSE(cast(kFloor, Sphere{{5, 5, 3}, 1}, {8, 0, 0}));
  EXPECT_FALSE(cast(kFloor, Sphere{{5, 5, 3}, 1}, {0, 0, 0}));
}

TEST(Law13Balls, TheEndOfTheWayCounts) {
  EXPECT_EQ(cast(kFloor, Sphere{{5, 5, 3}, 1}, {0, 0, -2}), (FirstContact{1, false}));
  EXPECT_FALSE(cast(kFloor, Sphere{{5, 5, 3}, 1}, {0, 0, std::nextafter(-2.0, 0)}));
}

TEST(Law13Balls, ATimeThatIsNoDoubleIsRoundedDown) {
  const auto third = cast(kFloor, Sphere{{5, 5, 2}, 1}, {0, 0, -3});
  ASSERT_TRUE(third);
  EXPECT_LE(std::fma(third->time, 3, -1), 0);
  EXPECT_GT(std::fma(std::nextafter(third->time, 1), 3, -1), 0);
  // A corner one beside a ball of two: the centre is the root of three above it.
  const auto root = cast(kFloor, Sphere{{-1, 0, 4}, 2}, {0, 0, -4});
  ASSERT_TRUE(root);
  EXPECT_EQ(root->time, 0x1.224c28bd3d9aap-1);  // 1 - sqrt(3) / 4 = 0.5669872981077807
}

TEST(Law13Balls, TouchInPassingAtNoDouble) {
  // The corner is exactly five from the way, a third of which it is passed at.
  const Triangle corner{{0, 0, 0}, {-3, 0, -9}, {-3, 1, -9}};
  const auto met = cast(corner, Sphere{{-1, 3, 4}, 5}, {3, 0, 0});
  ASSERT_TRUE(met);
  EXPECT_EQ(met->time, 0x1.5555555555555p-2);
  EXPECT_FALSE(cast(corner, Sphere{{-1, 3, 4}, std::nextafter(5.0, 0)}, {3, 0, 0}));
  // Touching for 2^-25 of the way, and for less than 2^-500.
  EXPECT_TRUE(cast(corner, Sphere{{-1, 3, 4}, std::nextafter(5.0, 6)}, {3, 0, 0}));
  EXPECT_TRUE(cast(corner, Sphere{{-1, 0, 0x1p-1000}, 0x1p-1000}, {3, 0, 0}));
  EXPECT_FALSE(cast(corner, Sphere{{-1, 0, 0x1p-1000}, 0x1p-1001}, {3, 0, 0}));
}

TEST(Law13Balls, RollAlongAFaceUntilTheyMeetIt) {
  // The foot comes to the edge at a third of the way, at the height of the radius.
  EXPECT_EQ(cast(kFloor, Sphere{{-10, 5, 2}, 2}, {30, 0, 0}),
            (FirstContact{0x1.5555555555555p-2, false}));
  EXPECT_FALSE(cast(kFloor, Sphere{{-10, 5, std::nextafter(2.0, 3)}, 2}, {30, 0, 0}));
}

TEST(Law13Balls, WithoutARadiusArePoints) {
  EXPECT_EQ(cast(kFloor, Sphere{{5, 5, 3}, 0}, {0, 0, -12}), (FirstContact{0.25, false}));
  EXPECT_EQ(cast(kFloor, Sphere{{-1, 0, 0}, 0}, {2, 0, 0}), (FirstContact{0.5, false}));
  EXPECT_EQ(cast(kFloor, Sphere{{-1, -1, 1}, 0}, {2, 2, -2}), (FirstContact{0.5, false}));
  EXPECT_FALSE(cast(kFloor, Sphere{{-1, -1, 1}, 0}, {2, std::nextafter(2.0, 0), -2}));
}

TEST(Law13Balls, MeetTrianglesWithoutArea) {
  const Eigen::Vector3d p(1, 1, 0), q(5, 1, 0);
  EXPECT_EQ(cast({p, p, p}, Sphere{{1, 1, 3}, 1}, {0, 0, -8}), (FirstContact{0.25, false}));
  EXPECT_EQ(cast({q, p, q}, Sphere{{3, 1, 3}, 1}, {0, 0, -8}), (FirstContact{0.25, false}));
  EXPECT_FALSE(cast({q, p, q}, Sphere{{3, 3, 3}, 1}, {0, 0, -8}));
}

TEST(Law13Balls, MayMeetBeforeTheLeastDouble) {
  EXPECT_EQ(cast(kFloor, Sphere{{5, 5, 0x1p-900}, 0}, {0, 0, -0x1p900}), (FirstContact{0, false}));
  EXPECT_EQ(cast(kFloor, Sphere{{5, 5, 0x1p-900}, 0x1p-901}, {0, 0, -0x1p-900}),
            (FirstContact{0.5, false}));
}

TEST(Law13BallPolicy, WhatLeavesOrRollsGoesOn) {
  const Sphere on_face{{5, 5, 2}, 2}, on_edge{{5, -3, 4}, 5}, on_corner{{-3, 0, 4}, 5};
  for (const Sphere& ball : {on_face, on_edge, on_corner}) {
    EXPECT_EQ(cast(kFloor, ball, {0, 0, 1}), (FirstContact{0, true}));
    EXPECT_FALSE(cast(kFloor, ball, {0, 0, 1}, kLeft));
    EXPECT_FALSE(cast(kFloor, ball, {0, 0, 0}, kLeft));
    EXPECT_EQ(cast(kFloor, ball, {0, 0, -0x1p-1000}, kLeft), (FirstContact{0, true}));
  }
  EXPECT_FALSE(cast(kFloor, on_face, {100, 1, 0}, kLeft));
  EXPECT_FALSE(cast(kFloor, on_corner, {0, 1, 0}, kLeft));
  EXPECT_EQ(cast(kFloor, on_corner, {1, 0, 0}, kLeft), (FirstContact{0, true}));
  // What is inside at the start is met, wherever it goes.
  EXPECT_EQ(cast(kFloor, Sphere{{5, 5, 1}, 2}, {0, 0, 9}, kLeft), (FirstContact{0, true}));
  // A point has no inside.
  EXPECT_FALSE(cast(kFloor, Sphere{{5, 5, 0}, 0}, {0, 0, -1}, kLeft));
  EXPECT_EQ(cast(kFloor, Sphere{{5, 5, 3}, 1}, {0, 0, -8}, kLeft), (FirstContact{0.25, false}));
}

std::string message_of(const Triangle& t, const Sphere& ball, const Eigen::Vector3d& d,
                       const CastSettings& settings = {}) {
  try {
    cast(t, ball, d, settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Law13BallDoor, RefusesWhatIsNoBall) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Sphere ball{{0, 0, 3}, 1};
  Triangle bad = kFloor;
  bad.b.y() = kNan;
  EXPECT_NE(message_of(bad, ball, {0, 0, 1}).find("triangle"), std::string::npos);
  EXPECT_NE(message_of(kFloor, Sphere{{0, kNan, 3}, 1}, {0, 0, 1}).find("ball"), std::string::npos);
  EXPECT_NE(message_of(kFloor, Sphere{{0, 0, 3}, -1}, {0, 0, 1}).find("ball"), std::string::npos);
  EXPECT_NE(message_of(kFloor, Sphere{{0, 0, 3}, kInfinity}, {0, 0, 1}).find("ball"),
            std::string::npos);
  EXPECT_EQ(message_of(kFloor, ball, {0, kInfinity, 1}), "displacement: component y is not finite");
  EXPECT_NE(message_of(kFloor, ball, {0, 0, 1}, {.start = static_cast<StartContact>(7)}), "");
}

TEST(BallPassed, IsOnlySaidOfWhatIsNeverMet) {
  const Sphere ball{{5, 5, 3}, 1};
  using narrowphase::is_surely_passed;
  EXPECT_TRUE(is_surely_passed(kFloor, ball, {0, 0, -8}, 0.24));
  EXPECT_FALSE(is_surely_passed(kFloor, ball, {0, 0, -8}, 0.25));
  EXPECT_TRUE(is_surely_passed(kFloor, ball, {0, 0, 8}, 1));
  EXPECT_TRUE(is_surely_passed(kFloor, ball, {90, 0, 0}, 1));
  EXPECT_FALSE(is_surely_passed(kFloor, ball, {0, 0, -1e200}, 1));
}

}  // namespace
}  // namespace graze
