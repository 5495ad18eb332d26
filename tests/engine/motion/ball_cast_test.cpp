// Law 13 for a mesh and a ball: beside each triangle and the ball by going through time in rational
// arithmetic.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/volume_cast.h>
#include <graze/engine/mesh/volume_query.h>
#include <graze/narrowphase/triangle_distance.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/narrowphase/translation/rational_ball.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

/// The earliest of all triangles, of equal ones the lowest.
struct ExactBallCast {
  oracle::RationalBallCast cast;
  std::uint32_t triangle = 0;
};

bool is_earlier(const oracle::RationalBallCast& s, const oracle::RationalBallCast& t) {
  if (s.contact->time != t.contact->time) return s.contact->time < t.contact->time;
  if (s.contact->is_at_start || t.contact->is_at_start)
    return s.contact->is_at_start && !t.contact->is_at_start;
  // Roots of different polynomials are further apart than this, or equal.
  const mpf_class difference = s.time.value() - t.time.value();
  mpf_class least(1, 64);
  mpf_div_2exp(least.get_mpf_t(), least.get_mpf_t(), 4000);
  return difference < 0 && -difference > least;
}

ExactBallCast each_with_ball(const PlacedMesh& mesh, const Sphere& ball, const Eigen::Vector3d& d,
                             StartContact start) {
  ExactBallCast first;
  for (std::uint32_t i = 0; i < mesh.mesh.triangles().size(); ++i) {
    const auto found =
        oracle::rational_cast(place(mesh.pose, mesh.mesh.triangle(i)), ball, d, start);
    if (!found.contact) continue;
    if (!first.cast.contact || is_earlier(found, first.cast)) first = {found, i};
  }
  return first;
}

/// The point is of the triangle, and where the ball is at the time; the normal leads to its centre.
void expect_place(const PlacedMesh& mesh, const Sphere& ball, const Eigen::Vector3d& d,
                  const VolumeCast& found) {
  const Triangle triangle = place(mesh.pose, mesh.mesh.triangle(found.triangle));
  double largest = 0;
  for (const Eigen::Vector3d* corner : {&triangle.a, &triangle.b, &triangle.c})
    largest = std::max(largest, corner->cwiseAbs().maxCoeff());
  const double off = distance(triangle, Triangle{found.point, found.point, found.point}).distance;
  EXPECT_LE(off, 0x1p-52 * largest);
  EXPECT_NEAR(found.normal.norm(), 1, 0x1p-50);
  const Eigen::Vector3d arm = ball.centre + found.time * d - found.point;
  const double near = 0x1p-48 * (largest + ball.centre.norm() + ball.radius + d.norm());
  if (found.is_at_start) {
    EXPECT_LE(arm.norm(), ball.radius + near);
    return;
  }
  EXPECT_LE(found.normal.dot(d), 0x1p-48 * d.norm());
  EXPECT_NEAR(arm.norm(), ball.radius, near);
  EXPECT_LE((arm - ball.radius * found.normal).norm(), 4 * near);
}

void expect_exact(const PlacedMesh& mesh, const Sphere& ball, const Eigen::Vector3d& d,
                  StartContact start, int number) {
  const ExactBallCast right = each_with_ball(mesh, ball, d, start);
  const auto found = cast(mesh, ball, d, {.start = start});
  ASSERT_EQ(found.has_value(), right.cast.contact.has_value()) << number;
  if (!found) return;
  EXPECT_EQ(found->time, right.cast.contact->time) << number;
  EXPECT_EQ(found->is_at_start, right.cast.contact->is_at_start) << number;
  EXPECT_EQ(found->triangle, right.triangle) << number;
  if (start == StartContact::Counts) {
    EXPECT_EQ(found->is_at_start, intersects(mesh, ball)) << number;
  }
  expect_place(mesh, ball, d, *found);
}

TEST(Law13MeshAndBall, AreEachTriangleWithTheBall) {
  RandomSource source(235);
  int later = 0;
  for (int n = 0; n < 60; ++n) {
    const PlacedMesh mesh{tests::random_soup({.count = 20, .size = 0.3}, source),
                          tests::random_pose(0.5, source)};
    const Sphere ball{source.vector(-4, 4), n % 5 == 0 ? 0 : source.uniform(0, 0.5)};
    const Eigen::Vector3d d = source.uniform(0.5, 2) * (source.vector(-0.7, 0.7) - ball.centre);
    expect_exact(mesh, ball, d, StartContact::Counts, n);
    const auto found = cast(mesh, ball, d);
    later += found && !found->is_at_start;
  }
  EXPECT_GT(later, 10);
}

TEST(Law13MeshAndBall, AreExactOnLattices) {
  RandomSource source(236);
  int later = 0, at_start = 0, left = 0;
  for (int n = 0; n < 80; ++n) {
    const PlacedMesh mesh{tests::lattice_soup(8, 3, source)};
    const Sphere ball{source.lattice_point(-7, 7), 0.5 * static_cast<double>(source.integer(0, 6))};
    const Eigen::Vector3d d = source.integer(1, 3) * (source.lattice_point(-3, 3) - ball.centre);
    expect_exact(mesh, ball, d, StartContact::Counts, n);
    expect_exact(mesh, ball, d, StartContact::IsLeft, n);
    const auto found = cast(mesh, ball, d);
    later += found && !found->is_at_start;
    at_start += found && found->is_at_start;
    left += found != cast(mesh, ball, d, {.start = StartContact::IsLeft});
  }
  EXPECT_GT(later, 10);
  EXPECT_GT(at_start, 2);
  EXPECT_GT(left, 0);
}

const Mesh kFloor(std::vector<Eigen::Vector3d>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}},
                  std::vector<TriangleIndices>{{1, 3, 2}, {0, 1, 2}});

TEST(Law13MeshAndBall, OfTrianglesMetAtOnceTheLowestCounts) {
  // On the edge that both have, on the corner, and on either face.
  EXPECT_EQ(cast({kFloor}, Sphere{{2, 2, 3}, 1}, {0, 0, -8})->triangle, 0u);
  EXPECT_EQ(cast({kFloor}, Sphere{{4, 0, 3}, 1}, {0, 0, -8})->triangle, 0u);
  EXPECT_EQ(cast({kFloor}, Sphere{{1, 1, 3}, 1}, {0, 0, -8})->triangle, 1u);
  EXPECT_EQ(cast({kFloor}, Sphere{{3, 3, 3}, 1}, {0, 0, -8})->triangle, 0u);
  const auto landed = cast({kFloor}, Sphere{{1, 1, 3}, 1}, {0, 0, -8});
  EXPECT_EQ(*landed, (VolumeCast{0.25, false, 1, {1, 1, 0}, {0, 0, 1}}));
}

TEST(Law13MeshAndBall, OfManyAroundACornerTheLowestCounts) {
  constexpr std::uint32_t kAround = 48;
  std::vector<Eigen::Vector3d> vertices{{0, 0, 0}};
  std::vector<TriangleIndices> triangles;
  for (std::uint32_t i = 0; i < kAround; ++i) {
    const double angle = 2 * 3.14159265358979 * i / kAround;
    vertices.emplace_back(4 * std::cos(angle), 4 * std::sin(angle), -2);
    triangles.push_back({0, 1 + i, 1 + (i + 1) % kAround});
  }
  // The ball comes askew to a corner that all have, more than wait side by side.
  const Sphere ball{{0.5, 0.25, 4}, 1};
  const auto met = cast({Mesh(vertices, triangles)}, ball, {-0.75, -0.375, -4.5});
  ASSERT_TRUE(met);
  EXPECT_EQ(met->triangle, 0u);
  EXPECT_EQ(met->point, Eigen::Vector3d(0, 0, 0));
  // Another corner stands out by less than brackets of times tell.
  vertices.emplace_back(0, 0, 0x1p-50);
  triangles.push_back({1 + kAround, 1, 2});
  const auto sooner = cast({Mesh(vertices, triangles)}, ball, {-0.75, -0.375, -4.5});
  ASSERT_TRUE(sooner);
  EXPECT_EQ(sooner->triangle, kAround);
  EXPECT_LE(sooner->time, met->time);
}

TEST(Law13MeshAndBall, OfLargeAndSmallOnesTheLowestCounts) {
  // Times of the large one are known less well.
  for (const double side : {-1.0, 1.0}) {
    std::vector<Eigen::Vector3d> vertices{{-400 * side, -400, 0}, {-400 * side, 400, 0},
                                          {4 * side, 0, 0},       {-side, -1, 0},
                                          {-side, 1, 0},          {side, 0, 0}};
    std::vector<TriangleIndices> triangles{{0, 1, 2}, {3, 4, 5}};
    for (std::uint32_t i = 0; i < 8; ++i) {
      const double x = (i < 4 ? -200 : 2) * side, y = 4.0 * (i % 4);
      vertices.insert(vertices.end(), {{x, y + 3, -1}, {x + 1, y + 3, -1}, {x, y + 4, -1}});
      triangles.push_back({6 + 3 * i, 7 + 3 * i, 8 + 3 * i});
    }
    const auto met = cast({Mesh(vertices, triangles)}, Sphere{{0, 0, 2}, 1}, {0, 0, -3});
    ASSERT_TRUE(met);
    EXPECT_EQ(met->triangle, 0u);
  }
}

TEST(Law13MeshAndBall, TimesWithinOneDoubleAreOrdered) {
  // At (1 - height) / 3.
  const Mesh steps(
      std::vector<Eigen::Vector3d>{
          {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 0x1p-60}, {4, 0, 0x1p-60}, {0, 4, 0x1p-60}},
      std::vector<TriangleIndices>{{0, 1, 2}, {3, 4, 5}});
  const Sphere ball{{1, 1, 2}, 1};
  const auto landed = cast({steps}, ball, {0, 0, -3});
  EXPECT_EQ(landed->time, 0x1.5555555555555p-2);
  EXPECT_EQ(landed->triangle, 1u);
  EXPECT_EQ(landed->point.z(), 0x1p-60);
  // On two corners.
  const auto beside = cast({steps}, Sphere{{-1, 0, 2}, 0x1.6a09e667f3bcdp0}, {0, 0, -3});
  EXPECT_EQ(beside->triangle, 1u);
}

TEST(Law13MeshAndBall, WhatRestsRollsOnUntilItComesToAnother) {
  const Sphere ball{{1, 1, 0.5}, 0.5};
  const CastSettings kLeft{.start = StartContact::IsLeft};
  EXPECT_TRUE(cast({kFloor}, ball, {2, 2, 0})->is_at_start);
  const auto rolled = cast({kFloor}, ball, {2, 2, 0}, kLeft);
  ASSERT_TRUE(rolled);
  EXPECT_EQ(rolled->triangle, 0u);
  EXPECT_EQ(rolled->time, 0.5);
  EXPECT_FALSE(cast({kFloor}, ball, {0, 0, 1}, kLeft));
  EXPECT_TRUE(cast({kFloor}, ball, {0, 0, -1}, kLeft)->is_at_start);
}

TEST(Law13MeshAndBall, AtTheStartThePointIsTheNearest) {
  const auto face = cast({kFloor}, Sphere{{1, 1, -0.25}, 0.5}, {0, 0, 1});
  EXPECT_EQ(*face, (VolumeCast{0, true, 1, {1, 1, 0}, {0, 0, -1}}));
  const auto edge = cast({kFloor}, Sphere{{1, -0.25, 0}, 0.5}, {0, 0, 1});
  EXPECT_EQ(*edge, (VolumeCast{0, true, 1, {1, 0, 0}, {0, -1, 0}}));
  const auto corner = cast({kFloor}, Sphere{{-0.25, 0, 0}, 0.5}, {0, 0, 1});
  EXPECT_EQ(*corner, (VolumeCast{0, true, 1, {0, 0, 0}, {-1, 0, 0}}));
  const auto within = cast({kFloor}, Sphere{{1, 1, 0}, 0.5}, {0, 0, 1});
  EXPECT_EQ(*within, (VolumeCast{0, true, 1, {1, 1, 0}, {0, 0, -1}}));
}

TEST(Law13MeshAndBall, HugeAndTiny) {
  for (const double scale : {0x1p900, 0x1p-900, 0x1p-1060}) {
    const Mesh floor(std::vector<Eigen::Vector3d>{{0, 0, 0}, {4 * scale, 0, 0}, {0, 4 * scale, 0}},
                     std::vector<TriangleIndices>{{0, 1, 2}});
    const Sphere ball{{scale, scale, 2 * scale}, scale};
    const auto landed = cast({floor}, ball, {0, 0, -3 * scale});
    ASSERT_TRUE(landed);
    EXPECT_EQ(landed->time, 0x1.5555555555555p-2);
    EXPECT_EQ(landed->point, Eigen::Vector3d(scale, scale, 0));
    EXPECT_EQ(landed->normal, Eigen::Vector3d(0, 0, 1));
  }
  // A way so long that the time is below all doubles, and the place is told all the same.
  const Mesh speck(std::vector<Eigen::Vector3d>{{0, 0, 0}, {0x1p-900, 0, 0}, {0, 0x1p-900, 0}},
                   std::vector<TriangleIndices>{{0, 1, 2}});
  const auto landed =
      cast({speck}, Sphere{{0x1p-902, 0x1p-902, 0x1p-899}, 0x1p-901}, {0, 0, -0x1p900});
  ASSERT_TRUE(landed);
  EXPECT_EQ(landed->time, 0);
  EXPECT_FALSE(landed->is_at_start);
  EXPECT_EQ(landed->point, Eigen::Vector3d(0x1p-902, 0x1p-902, 0));
}

TEST(Law13MeshAndBall, FewTrianglesAreAsked) {
  RandomSource source(237);
  const Mesh mesh = tests::random_soup({.count = 5000, .size = 0.03}, source);
  std::uint64_t tests = 0;
  for (int n = 0; n < 20; ++n) {
    const Sphere ball{source.vector(-4, 4), 0.1};
    Work work;
    cast({mesh}, ball, -2 * ball.centre, {}, &work);
    tests += work.triangle_tests;
  }
  EXPECT_LT(tests, 20u * 500);
}

TEST(Law13MeshAndBall, RefusesWhatIsNoBall) {
  const double bad = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(cast({kFloor}, Sphere{{1, 1, 1}, -1}, {0, 0, 1}), InputError);
  EXPECT_THROW(cast({kFloor}, Sphere{{1, bad, 1}, 1}, {0, 0, 1}), InputError);
  EXPECT_THROW(cast({kFloor}, Sphere{{1, 1, 1}, 1}, {0, 0, bad}), InputError);
  EXPECT_THROW(
      cast({kFloor}, Sphere{{1, 1, 1}, 1}, {0, 0, 1}, {.start = static_cast<StartContact>(7)}),
      InputError);
  EXPECT_THROW(cast({kFloor}, Sphere{{1, 1, 1}, 0x1.8p1023}, {0, 0, 1}), PoseError);
  Pose skewed = Pose::Identity();
  skewed.linear() *= 2;
  EXPECT_THROW(cast({kFloor, skewed}, Sphere{{1, 1, 1}, 1}, {0, 0, 1}), PoseError);
}

}  // namespace
}  // namespace graze
