#include <graze/bvh/error.h>
#include <graze/engine/mesh/mesh_contacts.h>
#include <graze/engine/mesh/mesh_intersection.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/engine/contacts/placed_pairs.h"
#include "tests/shapes/closed_meshes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using tests::shifted;

Pose turned(const Eigen::Vector3d& axis, double angle, const Eigen::Vector3d& shift) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(angle, axis.normalized()).matrix();
  pose.translation() = shift;
  return pose;
}

void expect_same(const MeshContacts& one, const MeshContacts& other) {
  ASSERT_EQ(one.size(), other.size());
  EXPECT_EQ(one.points, other.points);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].point, other[i].point);
    EXPECT_EQ(one[i].point_a, other[i].point_a);
    EXPECT_EQ(one[i].point_b, other[i].point_b);
    EXPECT_EQ(one[i].normal, other[i].normal);
    EXPECT_EQ(one[i].depth, other[i].depth);
  }
}

/// Law 4.
void expect_mirrored(const MeshContacts& one, const MeshContacts& other) {
  ASSERT_EQ(one.size(), other.size());
  EXPECT_EQ(one.points, other.points);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].point, other[i].point);
    EXPECT_EQ(one[i].point_a, other[i].point_b);
    EXPECT_EQ(one[i].point_b, other[i].point_a);
    EXPECT_EQ(one[i].normal, -other[i].normal);
    EXPECT_EQ(one[i].depth, other[i].depth) << i;
  }
}

MeshContacts expect_sound(const PlacedMesh& a, const PlacedMesh& b) {
  const MeshContacts found = find_contacts(a, b);
  EXPECT_EQ(found.empty(), !intersects(a, b));
  EXPECT_EQ(found.completeness, Completeness::Complete);
  std::size_t points = 0;
  double last_depth = INFINITY;
  for (const MeshContact& contact : found) {
    EXPECT_NEAR(contact.normal.norm(), 1, 1e-15);
    EXPECT_GE(contact.depth, 0);
    EXPECT_LE(contact.depth, last_depth);
    last_depth = contact.depth;
    points += contact.point_count;
    EXPECT_GT(contact.point_count, 0u);
  }
  EXPECT_EQ(points, found.points.size());
  const MeshIntersection all = find_intersection(a, b);
  EXPECT_EQ(points, all.points.size()) << "each point in one contact";
  for (const PairVolume volume : kPairVolumes)
    expect_same(found, find_contacts(a, b, {.volume = volume}));
  return found;
}

MeshContacts expect_symmetric(const PlacedMesh& a, const PlacedMesh& b) {
  const MeshContacts found = expect_sound(a, b);
  expect_mirrored(found, find_contacts(b, a));
  return found;
}

TEST(MeshContacts, SpheresOverlapByTheirLens) {
  const Mesh sphere = tests::make_sphere(1, 31, 64);  // with a vertex on each axis
  const MeshContacts found = expect_symmetric({sphere}, {sphere, shifted(0, 0, 1.75)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].depth, 0.25, 1e-13);
  EXPECT_LT((found[0].normal - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LT((found[0].point - Eigen::Vector3d(0, 0, 0.875)).norm(), 1e-13);
  EXPECT_EQ(found[0].point_a, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(found[0].point_b, Eigen::Vector3d(0, 0, 0.75));
  // At any angle, to what the facets leave off: 1 - cos(pi / 32) of a radius on either side.
  RandomSource source(1);
  for (int n = 0; n < 15; ++n) {
    const Eigen::Vector3d way = source.vector(-1, 1).normalized();
    const double distance = source.uniform(1.2, 1.9);
    const Pose pose = turned(source.vector(-1, 1), 2, distance * way);
    const MeshContacts any = expect_symmetric({sphere}, {sphere, pose});
    ASSERT_EQ(any.size(), 1u);
    EXPECT_NEAR(any[0].depth, 2 - distance, 0.011);
    EXPECT_GT(any[0].normal.dot(way), 0.995);
    // What the depth claims: so far along the normal, and nothing of the lens is left.
    Pose apart = pose;
    apart.translation() += (any[0].depth + 1e-12) * any[0].normal;
    EXPECT_FALSE(intersects({sphere}, {sphere, apart}));
    EXPECT_LT((any[0].point - 0.5 * distance * way).norm(), 0.12);
  }
}

TEST(MeshContacts, ABoxPressedIntoATable) {
  const Mesh table = tests::make_box({4, 4, 1});
  const Mesh box = tests::make_box({0.5, 0.5, 0.5});
  for (const double x : {0.0, 0.3, -1.7}) {
    const MeshContacts found = expect_symmetric({table}, {box, shifted(x, 0.1, 1.375)});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].normal, Eigen::Vector3d(0, 0, 1)) << "flat loops have exact normals";
    EXPECT_NEAR(found[0].depth, 0.125, 1e-14);
    EXPECT_EQ(found[0].point_a.z(), 1);
    EXPECT_EQ(found[0].point_b.z(), 0.875);
  }
}

TEST(MeshContacts, ABoxRestingOnATableTouchesIt) {
  const Mesh table = tests::make_box({4, 4, 1});
  const Mesh box = tests::make_box({0.5, 0.5, 0.5});
  const MeshContacts found = expect_symmetric({table}, {box, shifted(0.25, 1, 1.5)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].normal, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(found[0].depth, 0);
  EXPECT_GE(found[0].point_count, 4u);
  const MeshContacts edge = expect_symmetric({table}, {box, shifted(4.5, 1, 1.5)});
  ASSERT_EQ(edge.size(), 1u);
  EXPECT_EQ(edge[0].depth, 0);
  EXPECT_GT(edge[0].normal.dot(Eigen::Vector3d(1, 0, 1).normalized()), 0.99);
  const MeshContacts corner = expect_symmetric({table}, {box, shifted(4.5, 4.5, 1.5)});
  ASSERT_EQ(corner.size(), 1u);
  EXPECT_EQ(corner[0].depth, 0);
  EXPECT_EQ(corner[0].point, Eigen::Vector3d(4, 4, 1));
  EXPECT_GT(corner[0].normal.dot(Eigen::Vector3d(1, 1, 1)), 0.9);
}

TEST(MeshContacts, StackedBoxesWithSidesInOnePlane) {
  const Mesh box = tests::make_box({1, 1, 1});
  const MeshContacts found = expect_symmetric({box}, {box, shifted(0, 0, 1.875)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].normal, Eigen::Vector3d(0, 0, 1));
  EXPECT_NEAR(found[0].depth, 0.125, 1e-14);
}

TEST(MeshContacts, ABoxInACornerOfARoomIsNotDeep) {
  // A profile with a floor and a wall, along y.
  const double profile[6][2] = {{-4, 0}, {4, 0}, {4, 1}, {-3, 1}, {-3, 5}, {-4, 5}};
  std::vector<Eigen::Vector3d> vertices;
  for (const double y : {-4.0, 4.0}) {
    for (const auto& [x, z] : profile)
      vertices.emplace_back(x, y, z);
  }
  std::vector<TriangleIndices> triangles;
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    triangles.push_back({i, i + 6, j});
    triangles.push_back({j, i + 6, j + 6});
  }
  for (const TriangleIndices& t : {TriangleIndices{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
    triangles.push_back(t);
    triangles.push_back({t[0] + 6, t[2] + 6, t[1] + 6});
  }
  const Mesh room(vertices, triangles);
  ASSERT_TRUE(room.topology().is_closed);
  const Mesh box = tests::make_box({0.5, 0.5, 0.5});
  const MeshContacts found = expect_symmetric({room}, {box, shifted(-2.5, 0, 1.5)});
  ASSERT_EQ(found.size(), 1u) << "two patches that share an edge";
  EXPECT_LT((found[0].normal - Eigen::Vector3d(1, 0, 1).normalized()).norm(), 1e-12);
  EXPECT_LT(found[0].depth, 1e-12);
}

TEST(MeshContacts, ACrossingPlateIsTwoContacts) {
  const Mesh sphere = tests::make_sphere(1, 31, 64);
  const Mesh plate = tests::make_box({3, 3, 0.01});
  const MeshContacts found = expect_symmetric({sphere}, {plate, shifted(0.01, 0.02, 0.3001)});
  ASSERT_EQ(found.size(), 2u);
  // From the loop on the plate's lower side it is inside on to the sphere's top, and the other way.
  EXPECT_LT(found[0].normal.z() * found[1].normal.z(), 0);
  EXPECT_GT(std::abs(found[0].normal.z()), 0.999);
}

/// A bar of square section along x, its sides in so many pieces.
Mesh make_bar(double from, double to, int pieces) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles = {{0, 2, 1}, {0, 3, 2}};
  for (int i = 0; i <= pieces; ++i) {
    const double x = from + (to - from) * i / pieces;
    for (const auto& [y, z] : {std::pair(-0.25, -0.25), {0.25, -0.25}, {0.25, 0.25}, {-0.25, 0.25}})
      vertices.emplace_back(x, y, z);
  }
  for (std::uint32_t i = 0; i < 4 * static_cast<std::uint32_t>(pieces); ++i) {
    const std::uint32_t next = i % 4 == 3 ? i - 3 : i + 1;
    triangles.push_back({i, next, next + 4});
    triangles.push_back({i, next + 4, i + 4});
  }
  const std::uint32_t end = 4 * static_cast<std::uint32_t>(pieces);
  triangles.push_back({end, end + 1, end + 2});
  triangles.push_back({end, end + 2, end + 3});
  return {vertices, triangles};
}

TEST(MeshContacts, WhatGoesThroughIsAsDeepWithoutAVertexInside) {
  const Mesh cube = tests::make_box({1, 1, 1});
  for (int pieces : {1, 2, 3, 6}) {
    SCOPED_TRACE(pieces);
    const MeshContacts through = expect_symmetric({cube}, {make_bar(-3, 3, pieces)});
    ASSERT_EQ(through.size(), 2u);
    for (const MeshContact& contact : through) {
      EXPECT_EQ(std::abs(contact.normal.x()), 1);
      EXPECT_EQ(contact.depth, 2);
      EXPECT_EQ(contact.point_a.x(), contact.normal.x());
      EXPECT_EQ(contact.point_b.x(), -contact.normal.x());
    }
    // It ends at the opposite side, which it touches from within: what leaves through the side
    // where it came in has to go as far.
    const MeshContacts within = expect_symmetric({cube}, {make_bar(-3, 1, pieces)});
    ASSERT_EQ(within.size(), 2u);
    for (const MeshContact& contact : within)
      EXPECT_EQ(contact.depth, 2) << contact.normal.transpose();
  }
}

TEST(MeshContacts, TouchingPointsHaveTheNormalOfWhatTheyTouch) {
  const std::vector<Eigen::Vector3d> tip = {{0, 0, 0}, {1, 0, 1}, {-1, 1, 1}, {-1, -3, 1}};
  const std::vector<TriangleIndices> sides = {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}};
  const Mesh cone(tip, sides);
  const Mesh table = tests::make_box({4, 4, 1});
  const MeshContacts touch = expect_symmetric({table}, {cone, shifted(0.5, 0.25, 1)});
  ASSERT_EQ(touch.size(), 1u);
  EXPECT_EQ(touch[0].normal, Eigen::Vector3d(0, 0, 1)) << "the table's, whatever the cone's";
  EXPECT_EQ(touch[0].depth, 0);
  EXPECT_EQ(touch[0].point, Eigen::Vector3d(0.5, 0.25, 1));
  const MeshContacts pressed = expect_symmetric({table}, {cone, shifted(0.5, 0.25, 0.75)});
  ASSERT_EQ(pressed.size(), 1u);
  EXPECT_NEAR(pressed[0].depth, 0.25, 1e-14);
  EXPECT_EQ(pressed[0].point_b, Eigen::Vector3d(0.5, 0.25, 0.75));
  EXPECT_EQ(pressed[0].normal, Eigen::Vector3d(0, 0, 1));

  const std::vector<Eigen::Vector3d> roof = {{-1, 0, 0}, {1, 0, 0},   {-1, 2, 1},
                                             {1, 2, 1},  {-1, -1, 1}, {1, -1, 1}};
  const std::vector<TriangleIndices> slopes = {{0, 2, 1}, {1, 2, 3}, {0, 1, 4}, {1, 5, 4}};
  const Mesh keel(roof, slopes);
  Pose across = Pose::Identity();
  across.linear() << 0, 1, 0, 1, 0, 0, 0, 0, -1;
  const MeshContacts crossing = expect_symmetric({keel, across}, {keel, shifted(0.125, 0.25, 0)});
  ASSERT_EQ(crossing.size(), 1u);
  EXPECT_EQ(crossing[0].normal, Eigen::Vector3d(0, 0, 1)) << "of both edges";
  EXPECT_EQ(crossing[0].depth, 0);
  const MeshContacts line = expect_symmetric({table}, {keel, shifted(0.125, 0.25, 1)});
  ASSERT_EQ(line.size(), 1u);
  EXPECT_EQ(line[0].normal, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(line[0].depth, 0);
}

TEST(MeshContacts, OpenSurfacesCountOnlyWhatCrosses) {
  // Two sheets that cross along a line which ends where they do.
  const Mesh sheet = tests::make_row(1);
  Pose upright = Pose::Identity();
  upright.linear() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  upright.translation() << 0.1, 0.2, -0.3;
  const MeshContacts found = expect_symmetric({sheet}, {sheet, upright});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LE(found[0].depth, 1.5);
  // A ball sunk into a wide sheet: its part below, not the sheet around.
  const std::vector<Eigen::Vector3d> corners = {{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}};
  const std::vector<TriangleIndices> quad = {{0, 1, 2}, {0, 2, 3}};
  const Mesh ground(corners, quad);
  const Mesh sphere = tests::make_sphere(1, 31, 64);
  const MeshContacts sunk = expect_symmetric({ground}, {sphere, shifted(0.3, 0.1, 0.875)});
  ASSERT_EQ(sunk.size(), 1u);
  EXPECT_NEAR(sunk[0].depth, 0.125, 1e-13);
  EXPECT_LT((sunk[0].normal - Eigen::Vector3d::UnitZ()).norm(), 1e-15);
}

TEST(MeshContacts, APartThatLeadsAroundAHandleIsNotEnclosed) {
  const Mesh torus = tests::make_torus(2, 0.5, 48, 24);
  // A disc, open, across the tube: one loop, from which the torus leads around to its other side.
  const std::vector<Eigen::Vector3d> corners = {
      {1, 0.01, -1}, {3, 0.02, -1}, {3, 0.03, 1}, {1, 0.01, 1}};
  const std::vector<TriangleIndices> quad = {{0, 1, 2}, {0, 2, 3}};
  const MeshContacts found = expect_symmetric({torus}, {Mesh(corners, quad)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT(found[0].depth, 0.7) << "no more than the triangles that cross";
}

class ContactsOfParts : public testing::TestWithParam<const char*> {};

TEST_P(ContactsOfParts, AreOnePerLoopAndSymmetric) {
  const tests::BundledPair pair(GetParam());
  for (std::size_t i = 0; i < pair.poses.size(); i += 9) {
    const PlacedMesh a{pair.mesh_a};
    const PlacedMesh b{pair.mesh_b, pair.poses[i]};
    const MeshContacts found = expect_symmetric(a, b);
    EXPECT_EQ(found.size(), find_intersection(a, b).curves.size());
  }
}

INSTANTIATE_TEST_SUITE_P(Bundled, ContactsOfParts,
                         testing::Values("rock-rock.touch", "rock-rock.deep", "link-link.touch",
                                         "bolt-nut.touch", "terrain-rock.touch"));

TEST(Law4Contacts, SoupsAndLattices) {
  RandomSource source(3);
  std::size_t contacts = 0;
  for (int n = 0; n < 60; ++n) {
    const Mesh a =
        n % 2 == 0 ? tests::lattice_soup(20, 2, source) : tests::random_soup({.count = 25}, source);
    const Mesh b =
        n % 2 == 0 ? tests::lattice_soup(20, 2, source) : tests::random_soup({.count = 25}, source);
    contacts += expect_symmetric({a}, {b, tests::random_pose(0.1, source)}).size();
    contacts += expect_symmetric({a}, {b}).size();
  }
  for (int n = 0; n < 40; ++n) {
    const Mesh a = tests::lattice_tetrahedra(3, 3, source);
    const Mesh b = tests::lattice_tetrahedra(3, 3, source);
    contacts += expect_symmetric({a}, {b}).size();
  }
  EXPECT_GT(contacts, 300u);
}

TEST(MeshContacts, CoincidentSurfacesStillHaveAContact) {
  const Mesh box = tests::make_box({1, 1, 1});
  const MeshContacts found = expect_sound({box}, {box});
  ASSERT_EQ(found.size(), 1u);
}

TEST(MeshContacts, ScalesAndOffsets) {
  const Mesh sphere = tests::make_sphere(1, 9, 12);
  const Pose pose = turned({1, 2, 3}, 0.5, {1.4, 0.5, 0.2});
  const MeshContacts once = find_contacts({sphere}, {sphere, pose});
  ASSERT_EQ(once.size(), 1u);
  for (const double scale : {0x1p-500, 0x1p-40, 0x1p500}) {
    const Mesh scaled = tests::mapped(sphere, scale, {0, 0, 0});
    Pose there = pose;
    there.translation() *= scale;
    const MeshContacts found = expect_symmetric({scaled}, {scaled, there});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].depth, once[0].depth * scale);
    EXPECT_EQ(found[0].normal, once[0].normal);
    EXPECT_EQ(found[0].point, once[0].point * scale);
  }
  const double offset = 1e9;
  Pose here = Pose::Identity();
  here.translation().setConstant(offset);
  Pose there = pose;
  there.translation() += here.translation();
  const MeshContacts far = expect_symmetric({sphere, here}, {sphere, there});
  ASSERT_EQ(far.size(), 1u);
  EXPECT_NEAR(far[0].depth, once[0].depth, 1e-4);
  EXPECT_GT(far[0].normal.dot(once[0].normal), 0.999);
}

TEST(MeshContacts, LimitsKeepTheDeepest) {
  const tests::BundledPair pair("gear-pinion.tight");
  const PlacedMesh a{pair.mesh_a};
  const PlacedMesh b{pair.mesh_b, pair.poses.back()};
  const MeshContacts all = find_contacts(a, b);
  ASSERT_GT(all.size(), 2u);
  const MeshContacts some = find_contacts(a, b, {.limit = 2});
  ASSERT_EQ(some.size(), 2u);
  EXPECT_EQ(some.completeness, Completeness::LimitReached);
  EXPECT_EQ(some[1].depth, all[1].depth);
  EXPECT_EQ(some.points.size(), some[0].point_count + some[1].point_count);
  EXPECT_EQ(find_contacts(a, b, {.limit = all.size()}).completeness, Completeness::Complete);
}

}  // namespace
}  // namespace graze
