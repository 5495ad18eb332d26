// Law 12 where the answer is known beforehand.

#include <graze/bvh/error.h>
#include <graze/narrowphase/first_contact.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/narrowphase/motion/random_paths.h"

namespace graze {
namespace {

using Point = Eigen::Vector3d;
using Contact = std::optional<FirstContact>;

constexpr FirstContactSettings kLeaving{.start = StartContact::IsLeft};
constexpr double kMax = std::numeric_limits<double>::max();
constexpr double kDenormal = std::numeric_limits<double>::denorm_min();

PointPath still(const Point& p) {
  return {p, p};
}

TrianglePath still(const Point& a, const Point& b, const Point& c) {
  return {still(a), still(b), still(c)};
}

EdgePath still_edge(const Point& a, const Point& b) {
  return {still(a), still(b)};
}

const TrianglePath kFloor = still({0, 0, 0}, {4, 0, 0}, {0, 4, 0});

Contact at(double time) {
  return FirstContact{time, false};
}

constexpr FirstContact kAtStart{0, true};

TEST(Law12, APointFallsThroughATriangle) {
  EXPECT_EQ(first_contact(PointPath{{1, 1, 1}, {1, 1, -1}}, kFloor), at(0.5));
  EXPECT_EQ(first_contact(PointPath{{1, 1, 1}, {1, 1, -3}}, kFloor), at(0.25));
  EXPECT_EQ(first_contact(PointPath{{5, 1, 1}, {5, 1, -1}}, kFloor), std::nullopt);
  EXPECT_EQ(first_contact(PointPath{{1, 1, 1}, {1, 1, 0}}, kFloor), at(1))
      << "contact at the end counts";
  EXPECT_EQ(first_contact(PointPath{{1, 1, 1}, {1, 1, kDenormal}}, kFloor), std::nullopt);
  EXPECT_EQ(first_contact(PointPath{{1, 1, 0}, {1, 1, 1}}, kFloor), kAtStart);
}

// 1/3 is no double: the largest one below it is the answer.
TEST(Law12, TimesAreRoundedDown) {
  const double third = 1.0 / 3;  // rounded down: 0x1.5555555555555p-2
  EXPECT_EQ(first_contact(PointPath{{1, 1, 1}, {1, 1, -2}}, kFloor), at(third));
  const double fifth = std::nextafter(0.2, 0);  // 0.2 is rounded up
  EXPECT_EQ(first_contact(PointPath{{1, 1, 1}, {1, 1, -4}}, kFloor), at(fifth));
  // So close to the end that the next double is 1.
  EXPECT_EQ(first_contact(PointPath{{1, 1, 1}, {1, 1, -0x1p-60}}, kFloor), at(1 - 0x1p-53));
  // And to the start: 2^-1074 / (1 + 2^-1074) is below the least double.
  EXPECT_EQ(first_contact(PointPath{{1, 1, kDenormal}, {1, 1, -1}}, kFloor), at(0));
  EXPECT_EQ(first_contact(PointPath{{1, 1, kDenormal}, {1, 1, -1}}, kFloor, kLeaving), at(0));
  EXPECT_EQ(first_contact(PointPath{{1, 1, kDenormal * 4}, {1, 1, -1}}, kFloor), at(kDenormal * 3));
}

TEST(Law12, EdgesAndCornersOfATriangleCount) {
  for (const Point& target : {Point{0, 0, 0}, Point{4, 0, 0}, Point{0, 4, 0}, Point{2, 0, 0},
                              Point{0, 1, 0}, Point{2, 2, 0}, Point{1, 3, 0}}) {
    const Point way{1, 2, 4};
    EXPECT_EQ(first_contact(PointPath{target - way, target + way}, kFloor), at(0.5));
  }
  // Past the edge by the least that there is.
  const double above = std::nextafter(4.0, 5);
  EXPECT_EQ(first_contact(PointPath{{above, 0, 1}, {above, 0, -1}}, kFloor), std::nullopt);
  EXPECT_EQ(first_contact(PointPath{{2, -kDenormal, 1}, {2, -kDenormal, -1}}, kFloor),
            std::nullopt);
}

TEST(Law12, TouchingWithoutGoingThroughIsAHit) {
  RandomSource source(5);
  for (int n = 0; n < 200; ++n) {
    const tests::PathQuery query = tests::random_paths(9, source);
    const Contact contact = first_contact(query.point(), query.triangle());
    ASSERT_TRUE(contact) << n;
    EXPECT_EQ(contact->time * 8, std::floor(contact->time * 8)) << "a double root at m / 8";
    EXPECT_EQ(contact->is_at_start, contact->time == 0);
  }
  // Two edges that turn past each other touch once: at t = 1/2 both cross the z-axis at 0, and the
  // product of their heights over it is a square.
  const EdgePath bar{{{-1, 0, 1}, {-1, 0, -1}}, {{1, 0, 1}, {1, 0, -1}}};
  EXPECT_EQ(first_contact(bar, still_edge({0, -1, 0}, {0, 1, 0})), at(0.5));
}

/// A point that stays over the inside of a triangle, and whose height over its plane is, times
/// something positive, y (1 + t) t + z (1 + t) - b / 4, with y = (1 + t) / 8 and z and b linear:
/// any polynomial of degree three whose highest coefficient is 1 / 8.
Contact over_inside(double z_end, double b_start, double b_end) {
  const TrianglePath triangle{
      still({0, 0, 0}), {{1, 0, b_start}, {2, 0, b_end}}, {{0, 1, 0}, {0, 1, -1}}};
  return first_contact(PointPath{{0.25, 0.125, 0}, {0.25, 0.25, z_end}}, triangle);
}

TEST(Law12, TheFirstOfThreeRootsCounts) {
  // (t - 1/4) (t - 1/2) (t - 3/4) / 8
  EXPECT_EQ(over_inside(-0.4375, 0.046875, 0.046875 - 1.59375), at(0.25));
  // (t - 1/4) (t - 1/2)^2 / 8: through the plane first, and then touching it.
  EXPECT_EQ(over_inside(-0.40625, 0.03125, 0.03125 - 1.375), at(0.25));
}

// At t = 1/3, which is no double, the point is in the plane and at a corner; and beyond the edge,
// by (3 t - 1)^2, before and after.
TEST(Law12, AConditionTouchesZeroWhereThePlaneIsReached) {
  const TrianglePath triangle{still({0, 0, 0}), {{1, -1, 0}, {1, 2, 0}}, still({0, 1, 0})};
  EXPECT_EQ(first_contact(PointPath{{-1, 0, -1}, {2, 0, 2}}, triangle), at(1.0 / 3));
  // The same a little later than it would have to be: no contact.
  EXPECT_EQ(first_contact(PointPath{{-1, 0, -1}, {2, 0, std::nextafter(2, 3)}}, triangle),
            std::nullopt);
}

TEST(Law12, InOnePlaneAlways) {
  const PointPath along{{-2, 1, 0}, {6, 1, 0}};
  EXPECT_EQ(first_contact(along, kFloor), at(0.25));
  EXPECT_EQ(first_contact(PointPath{{1, 1, 0}, {9, 1, 0}}, kFloor), kAtStart);
  EXPECT_EQ(first_contact(PointPath{{1, 1, 0}, {9, 1, 0}}, kFloor, kLeaving), std::nullopt);
  // Past a corner, and by it.
  EXPECT_EQ(first_contact(PointPath{{3, -1, 0}, {5, 1, 0}}, kFloor), at(0.5));
  EXPECT_EQ(first_contact(PointPath{{3, -2, 0}, {6, 1, 0}}, kFloor), std::nullopt);
  // Edges on one line, and parallel beside each other.
  const EdgePath one = still_edge({0, 0, 0}, {1, 0, 0});
  EXPECT_EQ(first_contact(one, EdgePath{{{5, 0, 0}, {-3, 0, 0}}, {{6, 0, 0}, {-2, 0, 0}}}),
            at(0.5));
  EXPECT_EQ(first_contact(one, EdgePath{{{0, 4, 0}, {0, -4, 0}}, {{3, 4, 0}, {3, -4, 0}}}),
            at(0.5));
  EXPECT_EQ(first_contact(one, EdgePath{{{2, 4, 0}, {2, -4, 0}}, {{3, 4, 0}, {3, -4, 0}}}),
            std::nullopt);
}

// A point in the plane leaves the triangle and comes back.
TEST(Law12, LeavingDropsTheFirstStretchAlone) {
  // Only the triangle moves: it passes over the point, and its far corner swings back.
  const TrianglePath fan{
      {{-1, -1, 0}, {-1, -1, 0}}, {{3, -1, 0}, {-3, -1, 0}}, {{-1, 3, 0}, {-1, 3, 0}}};
  EXPECT_EQ(first_contact(still({0, 0, 0}), fan), kAtStart);
  EXPECT_EQ(first_contact(still({0, 0, 0}), fan, kLeaving), std::nullopt);
  // Through the plane at 0 and again at 1/4: over (x, 1) the plane is 2 t (3 - x) / 4 high.
  const PointPath swing{{1, 1, 0}, {3, 1, 0.75}};
  const TrianglePath rising{{{0, 0, 0}, {0, 0, 2}}, {{4, 0, 0}, {4, 0, 0}}, {{0, 4, 0}, {0, 4, 0}}};
  EXPECT_EQ(first_contact(swing, rising), kAtStart);
  EXPECT_EQ(first_contact(swing, rising, kLeaving), at(0.25));
  const PointPath off{{1, 1, 0}, {1, 1, 1}};
  EXPECT_EQ(first_contact(off, kFloor, kLeaving), std::nullopt);
  // A contact that never ends is never begun again.
  EXPECT_EQ(first_contact(still({1, 1, 0}), kFloor, kLeaving), std::nullopt);
}

TEST(Law12, CollapsedFeatures) {
  // A triangle that is a segment, one that is a point, and one that comes to be a point.
  const TrianglePath segment = still({0, 0, 0}, {2, 0, 0}, {1, 0, 0});
  EXPECT_EQ(first_contact(PointPath{{1, 1, 1}, {1, -1, -1}}, segment), at(0.5));
  EXPECT_EQ(first_contact(PointPath{{3, 1, 1}, {3, -1, -1}}, segment), std::nullopt);
  const TrianglePath dot = still({1, 0, 0}, {1, 0, 0}, {1, 0, 0});
  EXPECT_EQ(first_contact(PointPath{{0, 0, 0}, {2, 0, 0}}, dot), at(0.5));
  EXPECT_EQ(first_contact(PointPath{{0, 1, 0}, {2, 0, 0}}, dot), std::nullopt);
  const TrianglePath shrinking{
      {{-1, -1, 0}, {1, 1, 0}}, {{1, -1, 0}, {-1, 1, 0}}, {{0, 1, 0}, {0, -1, 0}}};
  EXPECT_EQ(first_contact(PointPath{{0, 0, 1}, {0, 0, -1}}, shrinking), at(0.5));
  EXPECT_EQ(first_contact(PointPath{{0, 0.5, 1}, {0, 0.5, -1}}, shrinking), std::nullopt);
  const EdgePath point_edge = still_edge({1, 1, 0}, {1, 1, 0});
  EXPECT_EQ(first_contact(point_edge, EdgePath{{{0, 0, 1}, {0, 0, -1}}, {{2, 2, 1}, {2, 2, -1}}}),
            at(0.5));
  EXPECT_EQ(first_contact(still_edge({1, 1, 0}, {1, 1, 0}), still_edge({1, 1, 0}, {1, 1, 0})),
            kAtStart);
}

TEST(Law12, TwoTriangles) {
  const TrianglePath falling{
      {{1, 1, 2}, {1, 1, -2}}, {{2, 1, 3}, {2, 1, -1}}, {{1, 2, 3}, {1, 2, -1}}};
  EXPECT_EQ(first_contact(falling, kFloor), at(0.5));
  EXPECT_EQ(first_contact(kFloor, falling), at(0.5));
  const TrianglePath piercing = still({1, 1, -1}, {1, 1, 1}, {1, 2, 1});
  EXPECT_EQ(first_contact(piercing, kFloor), kAtStart);
  EXPECT_EQ(first_contact(piercing, kFloor, kLeaving), kAtStart) << "they cross at the start";
  const TrianglePath resting{
      {{1, 1, 0}, {1, 1, 1}}, {{2, 1, 1}, {2, 1, 2}}, {{1, 2, 1}, {1, 2, 2}}};
  EXPECT_EQ(first_contact(resting, kFloor), kAtStart);
  EXPECT_EQ(first_contact(resting, kFloor, kLeaving), std::nullopt);
  // Inside in one plane from the start: no corner or edge of theirs ever meets.
  const TrianglePath inner = still({0.5, 0.5, 0}, {1, 0.5, 0}, {0.5, 1, 0});
  EXPECT_EQ(first_contact(inner, kFloor), kAtStart);
}

TEST(Law12, TheLargestAndTheLeastCoordinates) {
  const TrianglePath vast = still({-kMax, -kMax, 0}, {kMax, -kMax, 0}, {0, kMax, 0});
  EXPECT_EQ(first_contact(PointPath{{0, 0, kMax}, {0, 0, -kMax}}, vast), at(0.5));
  EXPECT_EQ(first_contact(PointPath{{0, 0, kMax}, {0, 0, -kDenormal}}, vast), at(1 - 0x1p-53));
  const TrianglePath least = still({0, 0, 0}, {2 * kDenormal, 0, 0}, {0, 2 * kDenormal, 0});
  EXPECT_EQ(
      first_contact(
          PointPath{{kDenormal, kDenormal, kDenormal}, {kDenormal, kDenormal, -kDenormal}}, least),
      at(0.5));
  EXPECT_EQ(first_contact(PointPath{{kMax, kMax, kMax}, {-kMax, -kMax, -kMax}}, least), at(0.5));
}

TEST(Law12, WhatIsNotFiniteIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (double bad : {nan, infinity, -infinity}) {
    for (int place = 0; place < 24; ++place) {
      RandomSource source(3);
      tests::PathQuery query = tests::random_paths(0, source);
      PointPath& path = query.path[place / 6];
      (place % 6 < 3 ? path.start : path.end).data()[place % 3] = bad;
      EXPECT_THROW(first_contact(query.point(), query.triangle()), InputError) << place;
      EXPECT_THROW(first_contact(query.edge_a(), query.edge_b()), InputError) << place;
      EXPECT_THROW(first_contact(query.triangle(), TrianglePath{query.path[0], kFloor.a, kFloor.b}),
                   InputError);
    }
  }
  try {
    first_contact(PointPath{{0, 0, 0}, {0, nan, 0}}, kFloor);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "point: coordinate y at the end is not finite");
  }
  try {
    TrianglePath bad = kFloor;
    bad.c.start.x() = infinity;
    first_contact(bad, kFloor);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "triangle A: coordinate x of vertex c at the start is not finite");
  }
  EXPECT_THROW(first_contact(still({0, 0, 0}), kFloor, {.start = static_cast<StartContact>(7)}),
               InputError);
}

TEST(Law12, ManyAtOnceAreEachAlone) {
  RandomSource source(23);
  std::vector<PointPath> points;
  std::vector<TrianglePath> triangles;
  std::vector<EdgePath> edges_a, edges_b;
  for (int n = 0; n < 40; ++n) {
    const tests::PathQuery query = tests::random_paths(n % 10, source);
    points.push_back(query.point());
    triangles.push_back(query.triangle());
    edges_a.push_back(query.edge_a());
    edges_b.push_back(query.edge_b());
  }
  const std::vector<TrianglePath> others(triangles.rbegin(), triangles.rend());
  std::vector<Contact> of_points(40), of_edges(40), of_triangles(40);
  first_contacts(points, triangles, of_points);
  first_contacts(edges_a, edges_b, of_edges, kLeaving);
  first_contacts(triangles, others, of_triangles);
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_EQ(of_points[i], first_contact(points[i], triangles[i]));
    EXPECT_EQ(of_edges[i], first_contact(edges_a[i], edges_b[i], kLeaving));
    EXPECT_EQ(of_triangles[i], first_contact(triangles[i], others[i]));
  }
  first_contacts(std::span<const EdgePath>(), {}, {});
  EXPECT_THROW(first_contacts(points, triangles, std::span(of_points).first(39)), InputError);
  points[7].end.z() = std::numeric_limits<double>::infinity();
  try {
    first_contacts(points, triangles, of_points);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "point 7: coordinate z at the end is not finite");
  }
}

}  // namespace
}  // namespace graze
