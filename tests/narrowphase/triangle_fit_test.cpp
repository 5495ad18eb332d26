// Volumes around triangles: those around their corners, and axes that follow the surface.

#include <graze/bvh/error.h>
#include <graze/bvh/fit/aabb_fit.h>
#include <graze/bvh/fit/kdop_fit.h>
#include <graze/bvh/fit/obb_fit.h>
#include <graze/bvh/fit/sphere_fit.h>
#include <graze/narrowphase/triangle_fit.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/shapes/random_source.h"

namespace graze::tests {
namespace {

using Triangles = std::vector<Triangle>;
using Points = std::vector<Eigen::Vector3d>;

Triangles random_triangles(std::size_t count, RandomSource& source) {
  Triangles triangles;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d a = source.vector(-1, 1);
    const Eigen::Vector3d b = a + source.vector(-0.3, 0.3);
    triangles.push_back({a, b, a + source.vector(-0.3, 0.3)});
  }
  return triangles;
}

Points corners_of(const Triangles& triangles) {
  Points corners;
  for (const Triangle& triangle : triangles)
    corners.insert(corners.end(), {triangle.a, triangle.b, triangle.c});
  return corners;
}

void expect_equal(const Obb& box_a, const Obb& box_b) {
  EXPECT_EQ(box_a.pose.matrix(), box_b.pose.matrix());
  EXPECT_EQ(box_a.half_extents, box_b.half_extents);
}

TEST(TriangleFit, IsTheFitOfTheCorners) {
  RandomSource source(1);
  const Triangles triangles = random_triangles(40, source);
  const Points corners = corners_of(triangles);
  EXPECT_EQ(bounding_aabb(triangles).min, bounding_aabb(corners).min);
  EXPECT_EQ(bounding_aabb(triangles).max, bounding_aabb(corners).max);
  EXPECT_EQ(bounding_sphere(triangles).centre, bounding_sphere(corners).centre);
  EXPECT_EQ(bounding_sphere(triangles).radius, bounding_sphere(corners).radius);
  EXPECT_EQ(ritter_sphere(triangles).radius, ritter_sphere(corners).radius);
  EXPECT_EQ(bounding_kdop(triangles).min, bounding_kdop(corners).min);
  EXPECT_EQ(bounding_kdop(triangles).max, bounding_kdop(corners).max);
  expect_equal(ditetrahedron_box(triangles), ditetrahedron_box(corners));
  expect_equal(bounding_obb(triangles), bounding_obb(corners));
}

/// Each triangle in four by its edges' middles: the same surface.
Triangles divided(const Triangles& triangles) {
  Triangles result;
  for (const Triangle& t : triangles) {
    const Eigen::Vector3d ab = 0.5 * (t.a + t.b);
    const Eigen::Vector3d bc = 0.5 * (t.b + t.c);
    const Eigen::Vector3d ca = 0.5 * (t.c + t.a);
    result.insert(result.end(), {{t.a, ab, ca}, {ab, t.b, bc}, {ca, bc, t.c}, {ab, bc, ca}});
  }
  return result;
}

TEST(TriangleFit, CovarianceFollowsTheSurfaceNotItsDivision) {
  RandomSource source(2);
  for (int i = 0; i < 20; ++i) {
    const Triangles coarse = random_triangles(10, source);
    Triangles fine = coarse;
    const Triangles first = divided(divided({coarse[0]}));
    fine.erase(fine.begin());
    fine.insert(fine.end(), first.begin(), first.end());
    const Obb coarse_box = covariance_box(coarse);
    const Obb fine_box = covariance_box(fine);
    for (int k = 0; k < 3; ++k) {
      const double cosine = coarse_box.pose.linear().col(k).dot(fine_box.pose.linear().col(k));
      EXPECT_NEAR(std::abs(cosine), 1, 1e-10);
      EXPECT_NEAR(coarse_box.half_extents[k], fine_box.half_extents[k], 1e-8);
    }
    const double cosine = covariance_box(corners_of(coarse))
                              .pose.linear()
                              .col(0)
                              .dot(covariance_box(corners_of(fine)).pose.linear().col(0));
    EXPECT_LT(std::abs(cosine), 1 - 1e-6) << "the corners do not";
  }
}

TEST(TriangleFit, WithoutAreaTheCornersCount) {
  const Triangles segments{{{0, 0, 0}, {1, 2, 2}, {0, 0, 0}}, {{2, 4, 4}, {2, 4, 4}, {3, 6, 6}}};
  expect_equal(covariance_box(segments), covariance_box(corners_of(segments)));
  const Triangles points(3, Triangle{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}});
  EXPECT_EQ(covariance_box(points).half_extents, Eigen::Vector3d::Zero());
}

TEST(TriangleFit, BadInputIsRefused) {
  EXPECT_THROW(bounding_sphere(Triangles{}), InputError);
  EXPECT_THROW(covariance_box(Triangles{}), InputError);
  RandomSource source(3);
  Triangles triangles = random_triangles(5, source);
  triangles[2].b.z() = std::numeric_limits<double>::infinity();
  triangles[4].a.x() = std::nan("");
  try {
    covariance_box(triangles);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "triangle 2: coordinate z of vertex b is not finite");
  }
}

}  // namespace
}  // namespace graze::tests
