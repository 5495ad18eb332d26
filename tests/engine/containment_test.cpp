#include <graze/engine/mesh/containment.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/engine/rational_containment.h"
#include "tests/shapes/closed_meshes.h"
#include "tests/shapes/formula_meshes.h"

namespace graze {
namespace {

using oracle::contains_by_slanted_ray;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// How many points of each kind were compared.
struct Compared {
  int inside = 0;
  int outside = 0;
};

void compare(const Mesh& mesh, const Eigen::Vector3d& point, Compared& compared) {
  const bool expected = contains_by_slanted_ray(mesh, point);
  ++(expected ? compared.inside : compared.outside);
  ASSERT_EQ(contains(mesh, point), expected) << point.transpose();
}

/// The point and its neighbours, one double away along each axis.
void compare_around(const Mesh& mesh, const Eigen::Vector3d& point, Compared& compared) {
  compare(mesh, point, compared);
  for (int k = 0; k < 3; ++k) {
    for (double side : {-kInfinity, kInfinity}) {
      Eigen::Vector3d off = point;
      off[k] = std::nextafter(off[k], side);
      compare(mesh, off, compared);
    }
  }
}

TEST(Containment, RandomPointsInRandomTetrahedra) {
  RandomSource source(1);
  Compared compared;
  for (int n = 0; n < 60; ++n) {
    const Mesh mesh = tests::random_tetrahedra(1 + n % 7, 1, source);
    for (int i = 0; i < 40; ++i)
      compare(mesh, source.vector(-0.6, 0.6), compared);
  }
  EXPECT_GT(compared.inside, 200);
  EXPECT_GT(compared.outside, 200);
}

// Rays along the axes go through vertices and edges, along faces, and through flat tetrahedra.
TEST(Containment, LatticePointsInLatticeTetrahedra) {
  RandomSource source(2);
  Compared compared;
  for (int n = 0; n < 150; ++n) {
    const Mesh mesh = tests::lattice_tetrahedra(1 + n % 6, 2, source);
    for (int i = 0; i < 20; ++i) {
      compare(mesh, source.lattice_point(-2, 2), compared);
      compare(mesh, source.lattice_point(-4, 4) / 2, compared);
    }
  }
  EXPECT_GT(compared.inside, 500);
  EXPECT_GT(compared.outside, 500);
}

TEST(Containment, PointsOnTheSurfaceAndOneDoubleOffIt) {
  RandomSource source(3);
  Compared compared;
  for (int n = 0; n < 30; ++n) {
    const Mesh mesh = n % 2 == 0 ? tests::lattice_tetrahedra(3, 3, source)
                                 : tests::random_tetrahedra(3, 1, source);
    for (int i = 0; i < 6; ++i) {
      const Triangle t = mesh.triangle(static_cast<std::size_t>(source.integer(0, 11)));
      compare_around(mesh, t.a, compared);
      compare_around(mesh, (t.a + t.b) / 2, compared);
      compare_around(mesh, (t.a + t.b) / 4 + t.c / 2, compared);
    }
  }
  EXPECT_GT(compared.inside, 500);
  EXPECT_GT(compared.outside, 500);
}

TEST(Containment, ExtremeScalesAndOffsets) {
  RandomSource source(4);
  Compared compared;
  for (double scale : {1e-320, 1e-310, 1e-150, 1e150, 1e307}) {
    for (int n = 0; n < 8; ++n) {
      const Mesh unit = tests::random_tetrahedra(3, 1, source);
      const Mesh mesh = tests::mapped(unit, scale, Eigen::Vector3d::Zero());
      for (int i = 0; i < 4; ++i)
        compare(mesh, source.vector(-1, 1) * scale, compared);
      compare_around(mesh, mesh.triangle(1).b, compared);
    }
  }
  for (int n = 0; n < 20; ++n) {
    const Eigen::Vector3d offset = source.vector(-1e9, 1e9);
    const Mesh mesh = tests::mapped(tests::random_tetrahedra(2, 1, source), 1e-6, offset);
    compare_around(mesh, offset, compared);
    compare_around(mesh, mesh.triangle(2).c, compared);
  }
  EXPECT_GT(compared.inside, 100);
  EXPECT_GT(compared.outside, 100);
}

TEST(Containment, ShapesByFormula) {
  const Mesh torus = tests::make_torus(1, 0.3, 40, 20);
  EXPECT_FALSE(contains(torus, {0, 0, 0}));
  EXPECT_TRUE(contains(torus, {1, 0, 0}));
  EXPECT_TRUE(contains(torus, {0, -1, 0.2}));
  EXPECT_FALSE(contains(torus, {0, -1, 0.31}));
  const Mesh box = tests::make_box({1, 2, 4});
  EXPECT_TRUE(contains(box, {0, 0, 0}));
  EXPECT_TRUE(contains(box, {1, 2, 4}));
  EXPECT_TRUE(contains(box, {-1, 0.5, -4}));
  EXPECT_FALSE(contains(box, {std::nextafter(1.0, 2), 0, 0}));
  EXPECT_TRUE(contains(box, {std::nextafter(1.0, 0), 0, 0}));
}

TEST(Containment, ACavityIsOutside) {
  const Mesh outer = tests::make_box({2, 2, 2});
  const Mesh inner = tests::make_box({1, 1, 1});
  std::vector<Eigen::Vector3d> vertices(outer.vertices().begin(), outer.vertices().end());
  std::vector<TriangleIndices> triangles(outer.triangles().begin(), outer.triangles().end());
  vertices.insert(vertices.end(), inner.vertices().begin(), inner.vertices().end());
  for (const TriangleIndices& t : inner.triangles())
    triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  const Mesh hollow(vertices, triangles);
  EXPECT_FALSE(contains(hollow, {0, 0, 0}));
  EXPECT_TRUE(contains(hollow, {1, 0, 0})) << "on the wall of the cavity";
  EXPECT_TRUE(contains(hollow, {1.5, 0, 0}));
  EXPECT_FALSE(contains(hollow, {2.5, 0, 0}));
}

TEST(Containment, TrianglesAroundThePointAloneAreAskedToHoldIt) {
  const Mesh sphere = tests::make_sphere(1, 30, 30);
  Work far, on, inside;
  EXPECT_FALSE(contains(sphere, {2, 0, 0}, &far));
  EXPECT_EQ(far.triangle_tests, 0u);
  EXPECT_TRUE(contains(sphere, sphere.vertices()[100], &on));
  EXPECT_GT(on.triangle_tests, 0u);
  EXPECT_TRUE(contains(sphere, {0, 0, 0}, &inside));
  EXPECT_EQ(inside.triangle_tests, 0u) << "no triangle is near the centre";
  EXPECT_GT(inside.volume_tests, 0u);
}

TEST(Law10Containment, OpenMeshesAreRefusedWithTheirBoundary) {
  try {
    contains(tests::make_row(3), {0, 0, 0});
    FAIL();
  } catch (const MeshError& error) {
    EXPECT_STREQ(error.what(),
                 "the mesh is not closed: it has 9 boundary edges, the first from vertex 0 to "
                 "vertex 1 of triangle 0");
  }
}

TEST(Law10Containment, PointsThatAreNotFiniteAreRefused) {
  const Mesh box = tests::make_box({1, 1, 1});
  EXPECT_THROW(contains(box, {0, std::nan(""), 0}), InputError);
  EXPECT_THROW(contains(box, {0, 0, kInfinity}), InputError);
}

}  // namespace
}  // namespace graze
