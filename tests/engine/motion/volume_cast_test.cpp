// Law 13 for a mesh and a box: beside each triangle and the box by duality in rational arithmetic.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/volume_cast.h>
#include <graze/engine/mesh/volume_query.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/box_frame.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/narrowphase/translation/rational_cast.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

Aabb box_around(const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
  return {p.cwiseMin(q), p.cwiseMax(q)};
}

/// The earliest of all triangles, of equal ones the lowest.
struct ExactBoxCast {
  oracle::RationalCast cast;
  std::uint32_t triangle = 0;
};

ExactBoxCast each_with_box(const PlacedMesh& mesh, const Aabb& box, const Eigen::Vector3d& d) {
  ExactBoxCast first;
  for (std::uint32_t i = 0; i < mesh.mesh.triangles().size(); ++i) {
    const auto found = oracle::rational_cast(place(mesh.pose, mesh.mesh.triangle(i)), box, d);
    if (!found.contact) continue;
    if (!first.cast.contact || found.time < first.cast.time) first = {found, i};
  }
  return first;
}

void expect_exact(const PlacedMesh& mesh, const Aabb& box, const Eigen::Vector3d& d, int number) {
  const ExactBoxCast right = each_with_box(mesh, box, d);
  const auto found = cast(mesh, box, d);
  ASSERT_EQ(found.has_value(), right.cast.contact.has_value()) << number;
  if (!found) return;
  EXPECT_EQ(found->time, right.cast.contact->time) << number;
  EXPECT_EQ(found->is_at_start, right.cast.contact->is_at_start) << number;
  EXPECT_EQ(found->is_at_start, intersects(mesh, box)) << number;
  EXPECT_EQ(found->triangle, right.triangle) << number;
  EXPECT_LE(found->normal.dot(d), 0x1p-48 * d.norm());
  // The point is in the box where that has come to.
  for (int k = 0; k < 3; ++k) {
    const double x = found->point[k] - found->time * d[k], near = 0x1p-45 * (20 + d.norm());
    EXPECT_GE(x, box.min[k] - near) << number;
    EXPECT_LE(x, box.max[k] + near) << number;
  }
}

TEST(Law13Boxes, AreEachTriangleWithTheBox) {
  RandomSource source(135);
  int later = 0;
  for (int n = 0; n < 60; ++n) {
    const PlacedMesh mesh{tests::random_soup({.count = 20, .size = 0.3}, source),
                          tests::random_pose(0.5, source)};
    const Eigen::Vector3d from = source.vector(-4, 4);
    const Aabb box = box_around(from, from + source.vector(-0.5, 0.5));
    const Eigen::Vector3d d = source.uniform(0.5, 2) * (source.vector(-0.7, 0.7) - from);
    expect_exact(mesh, box, d, n);
    const auto found = cast(mesh, box, d);
    later += found && !found->is_at_start;
  }
  EXPECT_GT(later, 10);
}

TEST(Law13Boxes, AreExactOnLattices) {
  RandomSource source(136);
  int later = 0, at_start = 0;
  for (int n = 0; n < 80; ++n) {
    const PlacedMesh mesh{tests::lattice_soup(8, 3, source)};
    const Eigen::Vector3d from = source.lattice_point(-9, 9);
    const Aabb box = box_around(from, from + source.lattice_point(-2, 2));
    const Eigen::Vector3d d = source.integer(1, 3) * (source.lattice_point(-3, 3) - from);
    expect_exact(mesh, box, d, n);
    const auto found = cast(mesh, box, d);
    later += found && !found->is_at_start;
    at_start += found && found->is_at_start;
  }
  EXPECT_GT(later, 10);
  EXPECT_GT(at_start, 2);
}

TEST(Law13Boxes, OrientedOnesAreExactAfterLaw3) {
  RandomSource source(137);
  int later = 0;
  for (int n = 0; n < 60; ++n) {
    const PlacedMesh mesh{n % 2 == 0 ? tests::random_soup({.count = 20, .size = 0.3}, source)
                                     : tests::lattice_soup(10, 2, source),
                          tests::random_pose(0.5, source)};
    Pose pose = tests::random_pose(0, source);
    pose.translation() = source.vector(-4, 4);
    const Obb box{pose, source.vector(0, 0.5)};
    const Eigen::Vector3d d =
        source.uniform(0.5, 2) * (source.vector(-0.7, 0.7) - pose.translation());
    Eigen::Vector3d turned;
    for (int i = 0; i < 3; ++i) {
      const auto axis = pose.linear().col(i);
      turned[i] = (axis[0] * d[0] + axis[1] * d[1]) + axis[2] * d[2];
    }
    ExactBoxCast right;
    for (std::uint32_t i = 0; i < mesh.mesh.triangles().size(); ++i) {
      const Triangle framed =
          narrowphase::into_frame(place(mesh.pose, mesh.mesh.triangle(i)), pose);
      const auto found =
          oracle::rational_cast(framed, Aabb{-box.half_extents, box.half_extents}, turned);
      if (!found.contact) continue;
      if (!right.cast.contact || found.time < right.cast.time) right = {found, i};
    }
    const auto found = cast(mesh, box, d);
    ASSERT_EQ(found.has_value(), right.cast.contact.has_value()) << n;
    if (!found) continue;
    EXPECT_EQ(found->time, right.cast.contact->time) << n;
    EXPECT_EQ(found->is_at_start, intersects(mesh, box)) << n;
    EXPECT_EQ(found->triangle, right.triangle) << n;
    EXPECT_NEAR(found->normal.norm(), 1, 1e-14);
    const Eigen::Vector3d in_box = pose.inverse() * (found->point - found->time * d);
    for (int k = 0; k < 3; ++k)
      EXPECT_LE(std::abs(in_box[k]), box.half_extents[k] + 1e-12) << n;
    later += !found->is_at_start;
  }
  EXPECT_GT(later, 10);
}

TEST(Law13Boxes, AreSolidAndMayBeFlat) {
  const Mesh floor(std::vector<Eigen::Vector3d>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}},
                   std::vector<TriangleIndices>{{0, 1, 2}});
  const auto inside = cast({floor}, Aabb{{-9, -9, -9}, {9, 9, 9}}, {0, 0, 1});
  ASSERT_TRUE(inside);
  EXPECT_TRUE(inside->is_at_start);
  const auto landed = cast({floor}, Aabb{{1, 1, 1}, {2, 2, 3}}, {0, 0, -4});
  ASSERT_TRUE(landed);
  EXPECT_EQ(landed->time, 0.25);
  EXPECT_EQ(landed->normal, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(landed->point.z(), 0);
  const auto point = cast({floor}, Aabb{{1, 1, 1}, {1, 1, 1}}, {0, 0, -4});
  ASSERT_TRUE(point);
  EXPECT_EQ(point->point, Eigen::Vector3d(1, 1, 0));
  EXPECT_FALSE(cast({floor}, Aabb{{1, 1, 1}, {2, 2, 3}}, {0, 0, 4}));
  EXPECT_FALSE(cast({floor}, Aabb{{1, 1, 1}, {2, 2, 3}}, {0, 0, 0}));
}

TEST(Law13Boxes, HugeAndTiny) {
  for (const double scale : {0x1p900, 0x1p-900}) {
    const Mesh floor(std::vector<Eigen::Vector3d>{{0, 0, 0}, {4 * scale, 0, 0}, {0, 4 * scale, 0}},
                     std::vector<TriangleIndices>{{0, 1, 2}});
    const Aabb box{{scale, scale, scale}, {2 * scale, 2 * scale, 3 * scale}};
    const auto landed = cast({floor}, box, {0, 0, -3 * scale});
    ASSERT_TRUE(landed);
    EXPECT_EQ(landed->time, 0x1.5555555555555p-2);
  }
}

TEST(Law13Door, RefusesBoxesThatAreNone) {
  const Mesh floor(std::vector<Eigen::Vector3d>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}},
                   std::vector<TriangleIndices>{{0, 1, 2}});
  const double bad = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(cast({floor}, Aabb{{1, 1, 1}, {0, 2, 2}}, {0, 0, 1}), InputError);
  EXPECT_THROW(cast({floor}, Aabb{{1, 1, bad}, {2, 2, 2}}, {0, 0, 1}), InputError);
  EXPECT_THROW(cast({floor}, Aabb{{1, 1, 1}, {2, 2, 2}}, {0, 0, bad}), InputError);
  EXPECT_THROW(cast({floor}, Aabb{{1, 1, 1}, {2, 2, 0x1.8p1023}}, {0, 0, 1}), PoseError);
}

}  // namespace
}  // namespace graze
