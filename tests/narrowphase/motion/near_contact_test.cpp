// Law 12 with a clearance, in positions of which the answer is known.

#include <graze/bvh/error.h>
#include <graze/narrowphase/motion/near_contact.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "tests/narrowphase/motion/random_clearances.h"

namespace graze {
namespace {

PointPath still(const Eigen::Vector3d& p) {
  return {p, p};
}

const TrianglePath kFloor{still({0, 0, 0}), still({40, 0, 0}), still({0, 40, 0})};

TEST(Law12Near, FacesEdgesAndCornersAreComeNearTo) {
  EXPECT_EQ(first_contact(PointPath{{5, 5, 3}, {5, 5, -5}}, kFloor, {.clearance = 1}),
            (FirstContact{0.25, false}));
  // Three beside the edge, and the corner: four below.
  EXPECT_EQ(first_contact(PointPath{{5, -3, 8}, {5, -3, 0}}, kFloor, {.clearance = 5}),
            (FirstContact{0.5, false}));
  EXPECT_EQ(first_contact(PointPath{{-3, 0, 8}, {-3, 0, 0}}, kFloor, {.clearance = 5}),
            (FirstContact{0.5, false}));
  EXPECT_FALSE(first_contact(PointPath{{5, 5, 3}, {5, 5, 9}}, kFloor, {.clearance = 1}));
  // Two edges, one above the other.
  const EdgePath rail{still({-1, 0, 0}), still({1, 0, 0})};
  const EdgePath bar{{{0, -1, 3}, {0, -1, -5}}, {{0, 1, 3}, {0, 1, -5}}};
  EXPECT_EQ(first_contact(rail, bar, {.clearance = 1}), (FirstContact{0.25, false}));
}

TEST(Law12Near, TimesThatAreNoDoublesAreRoundedDown) {
  const auto third = first_contact(PointPath{{5, 5, 2}, {5, 5, -1}}, kFloor, {.clearance = 1});
  EXPECT_EQ(third, (FirstContact{0x1.5555555555555p-2, false}));
  // One beside the corner: the root of three above it, from four.
  const auto root = first_contact(PointPath{{-1, 0, 4}, {-1, 0, 0}}, kFloor, {.clearance = 2});
  EXPECT_EQ(root, (FirstContact{0x1.224c28bd3d9aap-1, false}));
}

TEST(Law12Near, AMomentInPassingCounts) {
  const TrianglePath corner{still({0, 0, 0}), still({-3, -1, -2}), still({-2, -2, -5})};
  const PointPath passes{{-1, 3, 4}, {2, 3, 4}};
  EXPECT_EQ(first_contact(passes, corner, {.clearance = 5}),
            (FirstContact{0x1.5555555555555p-2, false}));
  EXPECT_FALSE(first_contact(passes, corner, {.clearance = std::nextafter(5.0, 4)}));
}

TEST(Law12Near, WhatIsNearAtTheStartMayLeave) {
  const FirstContactSettings counts{.clearance = 1};
  const FirstContactSettings left{.start = StartContact::IsLeft, .clearance = 1};
  const PointPath rises{{5, 5, 0.5}, {5, 5, 9}};
  EXPECT_EQ(first_contact(rises, kFloor, counts), (FirstContact{0, true}));
  EXPECT_FALSE(first_contact(rises, kFloor, left));
  // It leaves, and the floor comes after it.
  const TrianglePath lifted{{{0, 0, 0}, {0, 0, 20}}, {{40, 0, 0}, {40, 0, 0}}, still({0, 40, 0})};
  const auto met = first_contact(PointPath{{1, 1, 1}, {1, 1, 9}}, lifted, counts);
  EXPECT_EQ(met, (FirstContact{0, true}));
  // Always exactly as far.
  const PointPath along{{5, 5, 1}, {9, 9, 1}};
  EXPECT_EQ(first_contact(along, kFloor, counts), (FirstContact{0, true}));
  EXPECT_FALSE(first_contact(along, kFloor, left));
}

TEST(Law12Near, SlidingInAtTheClearanceIsThroughAnEdge) {
  // At the height of the clearance all the way: near from where the foot comes over the edge.
  EXPECT_EQ(first_contact(PointPath{{-10, 5, 2}, {20, 5, 2}}, kFloor, {.clearance = 2}),
            (FirstContact{0x1.5555555555555p-2, false}));
  EXPECT_FALSE(first_contact(PointPath{{-10, 5, 2}, {20, 5, 2}}, kFloor,
                             {.clearance = std::nextafter(2.0, 1)}));
}

TEST(Law12Near, TrianglesComeNearByTheirFeatures) {
  const TrianglePath falls{
      {{5, 5, 3}, {5, 5, -5}}, {{6, 5, 4}, {6, 5, -4}}, {{5, 6, 4}, {5, 6, -4}}};
  EXPECT_EQ(first_contact(kFloor, falls, {.clearance = 1}), (FirstContact{0.25, false}));
  EXPECT_EQ(first_contact(falls, kFloor, {.clearance = 1}), (FirstContact{0.25, false}));
  EXPECT_EQ(first_contact(kFloor, kFloor, {.clearance = 1}), (FirstContact{0, true}));
  // Corners alone that are near count, not what goes through.
  const TrianglePath through{still({5, 5, -9}), still({5, 6, -9}), still({5, 5, 9})};
  EXPECT_EQ(first_contact(kFloor, through, {.clearance = 1}), (FirstContact{0, true}));
}

TEST(Law12Near, AClearanceOfNothingIsContact) {
  const PointPath falls{{5, 5, 3}, {5, 5, -5}};
  EXPECT_EQ(first_contact(falls, kFloor, {.clearance = 0}), first_contact(falls, kFloor));
  EXPECT_EQ(first_contact(falls, kFloor, {.clearance = 0x1p-1074}),
            (FirstContact{0.375 - 0x1p-54, false}));
}

TEST(Law12Near, ManyAreEachAsAlone) {
  RandomSource source(91);
  std::vector<PointPath> points;
  std::vector<TrianglePath> triangles;
  for (int n = 0; n < 30; ++n) {
    const tests::ClearanceQuery query = tests::random_clearance(1, source);
    points.push_back(query.paths.point());
    triangles.push_back(query.paths.triangle());
  }
  std::vector<std::optional<FirstContact>> contacts(points.size());
  first_contacts(points, triangles, contacts, {.clearance = 0.75});
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(contacts[i], first_contact(points[i], triangles[i], {.clearance = 0.75}));
}

TEST(Law12Near, TheRoundedStageIsRight) {
  RandomSource source(92);
  int passed = 0;
  for (int n = 0; n < 400; ++n) {
    const tests::ClearanceQuery query = tests::random_clearance(n % 9, source);
    const FirstContactSettings settings{.clearance = query.clearance};
    const PointPath one = query.paths.point();  // what FourPaths refers to
    const TrianglePath triangle = query.paths.triangle();
    const EdgePath a = query.paths.edge_a(), b = query.paths.edge_b();
    const narrowphase::FourPaths point(one, triangle);
    const narrowphase::FourPaths edges(a, b);
    for (const auto* paths : {&point, &edges}) {
      if (!narrowphase::are_surely_further(*paths, query.clearance, 1)) continue;
      ++passed;
      EXPECT_FALSE(narrowphase::near_contact_exactly(*paths, settings)) << n;
    }
  }
  EXPECT_GT(passed, 50);
}

TEST(Law12NearDoor, RefusesWhatIsNoDistance) {
  const PointPath falls{{5, 5, 3}, {5, 5, -5}};
  const double bad = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double clearance : {-1.0, bad, infinite})
    EXPECT_THROW(first_contact(falls, kFloor, {.clearance = clearance}), InputError);
  EXPECT_THROW(first_contact(PointPath{{5, bad, 3}, {5, 5, -5}}, kFloor, {.clearance = 1}),
               InputError);
}

}  // namespace
}  // namespace graze
