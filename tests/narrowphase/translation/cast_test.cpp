// Law 13 of two triangles in positions of which the answer is known.

#include <graze/bvh/error.h>
#include <graze/narrowphase/cast.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace graze {
namespace {

constexpr CastSettings kLeft{.start = StartContact::IsLeft};

const Triangle kFloor{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

Triangle lifted(const Triangle& t, double height) {
  const Eigen::Vector3d by(0, 0, height);
  return {t.a + by, t.b + by, t.c + by};
}

TEST(Law13Triangles, ATimeThatIsNoDoubleIsRoundedDown) {
  // A corner one above the floor, on a way of three, and one of ten.
  const Triangle wedge{{1, 1, 1}, {1, 2, 5}, {2, 1, 5}};
  const auto third = cast(kFloor, wedge, {0, 0, -3});
  ASSERT_TRUE(third);
  EXPECT_LE(std::fma(third->time, 3, -1), 0);
  EXPECT_GT(std::fma(std::nextafter(third->time, 1), 3, -1), 0);
  const auto tenth = cast(kFloor, wedge, {0, 0, -10});
  ASSERT_TRUE(tenth);
  EXPECT_LE(std::fma(tenth->time, 10, -1), 0);
  EXPECT_GT(std::fma(std::nextafter(tenth->time, 1), 10, -1), 0);
}

TEST(Law13Triangles, TheEndOfTheWayCounts) {
  const Triangle wedge{{1, 1, 1}, {1, 2, 5}, {2, 1, 5}};
  EXPECT_EQ(cast(kFloor, wedge, {0, 0, -1}), (FirstContact{1, false}));
  EXPECT_FALSE(cast(kFloor, wedge, {0, 0, -1 + 0x1p-53}));
  EXPECT_FALSE(cast(kFloor, wedge, {0, 0, 1}));
}

TEST(Law13Triangles, MayMeetBeforeTheLeastDouble) {
  const Triangle wedge{{1, 1, 0x1p-900}, {1, 2, 5}, {2, 1, 5}};
  EXPECT_EQ(cast(kFloor, wedge, {0, 0, -0x1p900}), (FirstContact{0, false}));
  EXPECT_EQ(cast(kFloor, wedge, {0, 0, -0x1p-899}), (FirstContact{0.5, false}));
}

TEST(Law13Triangles, SlideInOnePlane) {
  const Triangle beside{{-3, 1, 0}, {-2, 1, 0}, {-3, 2, 0}};
  EXPECT_EQ(cast(kFloor, beside, {4, 0, 0}), (FirstContact{0.5, false}));
  EXPECT_FALSE(cast(kFloor, lifted(beside, 0x1p-1000), {4, 0, 0}));
  EXPECT_FALSE(cast(kFloor, beside, {0, 4, 0}));
  // In passing, corner to corner.
  const Triangle corner{{-1, -2, 0}, {-1, -1, 0}, {-2, -1, 0}};
  EXPECT_EQ(cast(kFloor, corner, {2, 2, 0}), (FirstContact{0.5, false}));
  EXPECT_EQ(cast(kFloor, corner, {2, 1, 0}), (FirstContact{1, false}));
  EXPECT_FALSE(cast(kFloor, corner, {2, 1 - 0x1p-53, 0}));
}

TEST(Law13Triangles, LandFlat) {
  EXPECT_EQ(cast(kFloor, lifted(kFloor, 1), {0, 0, -4}), (FirstContact{0.25, false}));
  EXPECT_EQ(cast(kFloor, lifted(kFloor, 1), {4, 0, -1}), (FirstContact{1, false}));
  EXPECT_FALSE(cast(kFloor, lifted(kFloor, 1), {4 + 0x1p-50, 0, -1}));
}

TEST(Law13Triangles, WithoutAreaAreSegmentsAndPoints) {
  const Eigen::Vector3d p(1, 1, 2), q(5, 5, 3);
  EXPECT_EQ(cast(kFloor, {p, p, p}, {0, 0, -4}), (FirstContact{0.5, false}));
  EXPECT_EQ(cast(kFloor, {q, p, q}, {0, 0, -4}), (FirstContact{0.5, false}));
  EXPECT_EQ(cast({p, p, p}, {q, q, q}, 2 * (p - q)), (FirstContact{0.5, false}));
  EXPECT_FALSE(cast({p, p, p}, {q, q, q}, {-8, -8, std::nextafter(-2.0, 0)}));
  EXPECT_EQ(cast({p, q, p}, {{3, 3, 5}, {3, 3, 9}, {3, 3, 7}}, {0, 0, -5}),
            (FirstContact{0.5, false}));
}

TEST(Law13Triangles, NoWayAsksWhereTheyAre) {
  EXPECT_EQ(cast(kFloor, kFloor, {0, 0, 0}), (FirstContact{0, true}));
  EXPECT_FALSE(cast(kFloor, lifted(kFloor, 1), {0, 0, 0}));
  EXPECT_FALSE(cast(kFloor, kFloor, {0, 0, 0}, kLeft));
}

TEST(Law13Policy, WhatLeavesOrSlidesGoesOn) {
  const Triangle standing{{1, 1, 0}, {2, 1, 0}, {1, 1, 3}};
  const Triangle on_corner{{1, 1, 0}, {2, 1, 3}, {1, 2, 3}};
  for (const Triangle& t : {standing, on_corner}) {
    EXPECT_EQ(cast(kFloor, t, {0, 0, 1}), (FirstContact{0, true}));
    EXPECT_FALSE(cast(kFloor, t, {0, 0, 1}, kLeft));
    EXPECT_FALSE(cast(kFloor, t, {1, 0, 0}, kLeft));
    EXPECT_EQ(cast(kFloor, t, {0, 0, -1}, kLeft), (FirstContact{0, true}));
    EXPECT_EQ(cast(kFloor, t, {1, 0, -0x1p-1000}, kLeft), (FirstContact{0, true}));
  }
}

TEST(Law13Policy, WhatCrossesAtTheStartIsMet) {
  const Triangle through{{1, 1, -1}, {2, 1, 2}, {1, 2, 2}};
  for (const Eigen::Vector3d& d : {Eigen::Vector3d(0, 0, 9), Eigen::Vector3d(0, 0, 0)})
    EXPECT_EQ(cast(kFloor, through, d, kLeft), (FirstContact{0, true}));
}

TEST(Law13Policy, LaterContactsAreTheSame) {
  EXPECT_EQ(cast(kFloor, lifted(kFloor, 1), {0, 0, -4}, kLeft), (FirstContact{0.25, false}));
}

std::string message_of(const Triangle& a, const Triangle& b, const Eigen::Vector3d& d,
                       const CastSettings& settings = {}) {
  try {
    cast(a, b, d, settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Law13Door, RefusesWhatIsNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Triangle bad = kFloor;
  bad.b.y() = kNan;
  EXPECT_NE(message_of(bad, kFloor, {0, 0, 1}).find("triangle A"), std::string::npos);
  EXPECT_NE(message_of(kFloor, bad, {0, 0, 1}).find("triangle B"), std::string::npos);
  EXPECT_EQ(message_of(kFloor, kFloor, {0, kInfinity, 1}),
            "displacement: component y is not finite");
  EXPECT_NE(message_of(kFloor, kFloor, {0, 0, 1}, {.start = static_cast<StartContact>(7)}), "");
}

}  // namespace
}  // namespace graze
