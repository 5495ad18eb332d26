#include <graze/narrowphase/ray/axis_line.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/shapes/closed_meshes.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::narrowphase {
namespace {

bool is_odd(const Mesh& mesh, const Eigen::Vector3d& point, int axis, LineCrossing side) {
  bool is_odd = false;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i)
    is_odd ^= cross_axis_line(mesh.triangle(i), point.data(), axis) == side;
  return is_odd;
}

/// The same answer on all six ways out, also from points on the surface: the moved point is one
/// point, wherever it is looked at from.
void expect_all_ways_alike(const Mesh& mesh, const Eigen::Vector3d& point) {
  const bool expected = is_odd(mesh, point, 0, LineCrossing::Above);
  for (int axis = 0; axis < 3; ++axis) {
    for (LineCrossing side : {LineCrossing::Above, LineCrossing::Below})
      ASSERT_EQ(is_odd(mesh, point, axis, side), expected) << point.transpose() << ' ' << axis;
  }
}

TEST(AxisLine, AllWaysOutOfAClosedMeshAgree) {
  RandomSource source(1);
  for (int n = 0; n < 400; ++n) {
    const Mesh lattice = tests::lattice_tetrahedra(1 + n % 5, 2, source);
    for (int i = 0; i < 40; ++i)
      expect_all_ways_alike(lattice, source.lattice_point(-4, 4) / 2);
    const Mesh random = tests::random_tetrahedra(1 + n % 5, 1, source);
    const Triangle t = random.triangle(1);
    for (const Eigen::Vector3d& point :
         {t.a, Eigen::Vector3d((t.a + t.b) / 2), source.vector(-1, 1)})
      expect_all_ways_alike(random, point);
  }
}

// The moved point is beyond the lower faces of a box in its corners, and beyond the upper ones too.
TEST(AxisLine, ThePointIsMovedTowardsLargerCoordinates) {
  const Mesh box = tests::make_box({1, 1, 1});
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d point(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    EXPECT_EQ(is_odd(box, point, 2, LineCrossing::Above), corner == 0) << corner;
  }
}

TEST(AxisLine, ATriangleIsAboveOrBelow) {
  const Triangle t{{0, 0, 1}, {4, 0, 3}, {0, 4, 1}};
  const auto cross = [&](double x, double y, double z) {
    return cross_axis_line(t, Eigen::Vector3d(x, y, z).data(), 2);
  };
  EXPECT_EQ(cross(1, 1, 0), LineCrossing::Above);
  EXPECT_EQ(cross(1, 1, std::nextafter(1.5, 0)), LineCrossing::Above);
  EXPECT_EQ(cross(1, 1, std::nextafter(1.5, 2)), LineCrossing::Below);
  EXPECT_EQ(cross(1, 1, 1.5), LineCrossing::Above)
      << "the triangle rises along x, as the shift does";
  EXPECT_EQ(cross(1, 1, 4), LineCrossing::Below);
  EXPECT_EQ(cross(-0.5, 1, 0), LineCrossing::None);
  EXPECT_EQ(cross(0, 1, 0), LineCrossing::Above) << "an edge at its lower x is crossed";
  EXPECT_EQ(cross(2, 2, 0), LineCrossing::None) << "an edge at its upper x is not";
  EXPECT_EQ(cross_axis_line({t.a, t.b, t.b}, Eigen::Vector3d(2, 0, 0).data(), 2),
            LineCrossing::None);
}

TEST(AxisLine, UprightTrianglesAreNotCrossed) {
  RandomSource source(2);
  for (int n = 0; n < 1000; ++n) {
    Triangle t{source.lattice_point(-2, 2), source.lattice_point(-2, 2),
               source.lattice_point(-2, 2)};
    const int axis = n % 3;
    t.c = t.a;
    t.c[axis] += source.integer(-2, 2);
    EXPECT_EQ(cross_axis_line(t, source.lattice_point(-2, 2).data(), axis), LineCrossing::None);
  }
}

}  // namespace
}  // namespace graze::narrowphase
