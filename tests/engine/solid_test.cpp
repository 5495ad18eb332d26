#include <graze/engine/mesh/containment.h>
#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/self.h>
#include <graze/engine/mesh/volume_query.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/box_frame.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/engine/rational_containment.h"
#include "tests/shapes/closed_meshes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using oracle::contains_by_slanted_ray;

constexpr QuerySettings kSolid{.hit = Hit::Solid};
constexpr VolumeQuerySettings kSolidMesh{.interior = Interior::Solid};

Pose moved_by(const Eigen::Vector3d& translation) {
  Pose pose = Pose::Identity();
  pose.translation() = translation;
  return pose;
}

/// Several meshes as one.
Mesh together(const std::vector<Mesh>& meshes) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (const Mesh& mesh : meshes) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), mesh.vertices().begin(), mesh.vertices().end());
    for (const TriangleIndices& t : mesh.triangles())
      triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return Mesh(vertices, triangles);
}

/// The mesh with every vertex placed, and what `into` makes of it.
template <typename Into>
Mesh baked(const PlacedMesh& placed, Into&& into) {
  std::vector<Eigen::Vector3d> vertices;
  for (const Eigen::Vector3d& p : placed.mesh.vertices())
    vertices.push_back(into(place(placed.pose, p)));
  return Mesh(vertices, placed.mesh.triangles());
}

Mesh baked(const PlacedMesh& placed) {
  return baked(placed, [](const Eigen::Vector3d& p) { return p; });
}

/// By all pairs of triangles, and all vertices of each in the other by slanted rays in rationals.
bool intersects_by_brute_force(const PlacedMesh& a, const PlacedMesh& b) {
  const Mesh placed_a = baked(a);
  const Mesh placed_b = baked(b);
  for (std::size_t i = 0; i < a.mesh.triangles().size(); ++i) {
    for (std::size_t j = 0; j < b.mesh.triangles().size(); ++j) {
      if (intersects(placed_a.triangle(i), placed_b.triangle(j))) return true;
    }
  }
  for (const Eigen::Vector3d& p : placed_a.vertices()) {
    if (contains_by_slanted_ray(placed_b, p)) return true;
  }
  for (const Eigen::Vector3d& p : placed_b.vertices()) {
    if (contains_by_slanted_ray(placed_a, p)) return true;
  }
  return false;
}

struct Seen {
  int touching = 0;
  int inside = 0;
  int apart = 0;
};

void compare(const PlacedMesh& a, const PlacedMesh& b, Seen& seen) {
  const bool expected = intersects_by_brute_force(a, b);
  const bool is_touching = intersects(a, b);
  ++(is_touching ? seen.touching : expected ? seen.inside : seen.apart);
  ASSERT_EQ(intersects(a, b, kSolid), expected);
  ASSERT_EQ(intersects(b, a, kSolid), expected) << "law 4";
}

TEST(Solid, NestedSpheres) {
  const Mesh outer = tests::make_sphere(2, 20, 20);
  const Mesh inner = tests::make_sphere(1, 20, 20);
  EXPECT_FALSE(intersects({outer}, {inner}));
  EXPECT_TRUE(intersects({outer}, {inner}, kSolid));
  EXPECT_TRUE(intersects({inner}, {outer}, kSolid));
  EXPECT_TRUE(intersects({inner}, {outer, moved_by({0.5, 0.25, -0.25})}, kSolid));
  EXPECT_FALSE(intersects({inner}, {outer, moved_by({3.5, 0, 0})}, kSolid));
  EXPECT_FALSE(intersects({inner}, {outer, moved_by({2.2, 2.2, 0})}, kSolid)) << "boxes overlap";
  for (const PairVolume volume : kPairVolumes) {
    EXPECT_TRUE(intersects({outer}, {inner}, {.volume = volume, .hit = Hit::Solid}));
  }
}

TEST(Solid, ShellsWithinShellsByTheEvenOddRule) {
  const Mesh hollow = together({tests::make_box({4, 4, 4}), tests::make_box({2, 2, 2})});
  const Mesh small = tests::make_box({0.5, 0.5, 0.5});
  EXPECT_FALSE(intersects({hollow}, {small}, kSolid)) << "in the cavity";
  EXPECT_TRUE(intersects({hollow}, {small, moved_by({3, 0, 0})}, kSolid)) << "in the wall";
  EXPECT_FALSE(intersects({hollow}, {small, moved_by({5, 0, 0})}, kSolid));
  const Mesh wide = tests::make_box({8, 8, 8});
  EXPECT_TRUE(intersects({hollow}, {wide}, kSolid)) << "around it";
  const Mesh between = tests::make_box({3, 3, 3});
  EXPECT_TRUE(intersects({hollow}, {between}, kSolid)) << "around the cavity, in the wall";
  const Mesh thrice = together({hollow, tests::make_box({1, 1, 1})});
  EXPECT_TRUE(intersects({thrice}, {small}, kSolid)) << "the third shell is solid again";
  EXPECT_FALSE(intersects({together({hollow, hollow})}, {small, moved_by({3, 0, 0})}, kSolid))
      << "twice the same: enclosed an even number of times";
}

TEST(Solid, TouchingFromInsideIsTouching) {
  const Mesh outer = tests::make_box({4, 4, 4});
  const Mesh inner = tests::make_box({1, 1, 1});
  Work touching;
  EXPECT_TRUE(intersects({outer}, {inner, moved_by({3, 0, 0})}, kSolid, &touching));
  EXPECT_EQ(touching.points_tested, 0u) << "surfaces touch: no point is asked for";
  Work inside;
  EXPECT_TRUE(intersects({outer}, {inner, moved_by({3 - 0x1p-51, 0, 0})}, kSolid, &inside));
  EXPECT_GT(inside.points_tested, 0u);
  Work surface;
  EXPECT_FALSE(intersects({outer}, {inner}, &surface));
  EXPECT_EQ(surface.points_tested, 0u) << "nothing is done that was not asked for";
}

TEST(Solid, OnePointOfEachPartDecides) {
  RandomSource source(1);
  std::vector<Mesh> parts;
  for (int i = 0; i < 200; ++i) {
    parts.push_back(tests::mapped(tests::make_box({0.5, 0.5, 0.5}), 0.25,
                                  Eigen::Vector3d(10 + i, source.integer(-9, 9), 0)));
  }
  const Mesh outside = together(parts);
  EXPECT_EQ(outside.component_vertices().size(), 200u);
  const Mesh ball = tests::make_sphere(2, 20, 20);
  EXPECT_FALSE(intersects({ball}, {outside}, kSolid));
  parts.insert(parts.begin() + 77, tests::make_box({0.5, 0.5, 0.5}));
  const Mesh one_inside = together(parts);
  EXPECT_EQ(one_inside.component_vertices().size(), 201u);
  EXPECT_TRUE(intersects({ball}, {one_inside}, kSolid));
  EXPECT_TRUE(intersects({one_inside}, {ball}, kSolid));
}

TEST(Solid, RandomPosesAgreeWithRationals) {
  RandomSource source(2);
  Seen seen;
  for (int n = 0; n < 300; ++n) {
    const Mesh a = tests::random_tetrahedra(1 + n % 3, 1, source);
    const Mesh b = tests::random_tetrahedra(1 + n % 2, 0.03, source);
    const Pose pose_a = tests::random_pose(0.3, source);
    compare({a, pose_a}, {b, tests::random_pose(0.3, source)}, seen);
  }
  EXPECT_GT(seen.inside, 10);
  EXPECT_GT(seen.apart, 10);
  EXPECT_GT(seen.touching, 10);
}

// Rays go through vertices, along edges and faces, and through flat tetrahedra.
TEST(Solid, LatticeMeshesAgreeWithRationals) {
  RandomSource source(3);
  Seen seen;
  Pose quarter = Pose::Identity();
  quarter.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  for (int n = 0; n < 250; ++n) {
    const Mesh a =
        tests::mapped(tests::lattice_tetrahedra(1 + n % 3, 3, source), 8, Eigen::Vector3d::Zero());
    const Mesh b = tests::lattice_tetrahedra(1 + n % 2, 1, source);
    quarter.translation() = source.lattice_point(-9, 9);
    compare({a}, {b, quarter}, seen);
  }
  EXPECT_GT(seen.inside, 15);
  EXPECT_GT(seen.apart, 15);
}

TEST(Solid, ExtremesOfScaleAndOffset) {
  RandomSource source(4);
  Seen seen;
  for (double scale : {1e-310, 1e-150, 1e-9, 1e9, 1e150, 1e300}) {
    for (int n = 0; n < 12; ++n) {
      const Mesh a =
          tests::mapped(tests::random_tetrahedra(1, 1, source), scale, Eigen::Vector3d::Zero());
      const Mesh b =
          tests::mapped(tests::random_tetrahedra(1, 0.05, source), scale, Eigen::Vector3d::Zero());
      const Pose pose_a = tests::random_pose(0.1 * scale, source);
      compare({a, pose_a}, {b, tests::random_pose(0.1 * scale, source)}, seen);
    }
  }
  for (double offset : {1e3, 1e6, 1e9, 1e14}) {
    for (int n = 0; n < 12; ++n) {
      const Eigen::Vector3d far = source.vector(-1, 1) * offset;
      const Mesh a = tests::random_tetrahedra(1, 1, source);
      const Mesh b = tests::mapped(tests::random_tetrahedra(1, 0.05, source), 1, far);
      Pose pose = tests::random_pose(0.1, source);
      pose.translation() += far;
      compare({a, pose}, {b}, seen);
    }
  }
  EXPECT_GT(seen.inside, 5);
  EXPECT_GT(seen.apart, 20);
}

/// Points on vertices, edges and faces of the placed mesh, and off them by one double: wherever the
/// point is not on the surface, parity is the oracle's answer, though the tree is in another frame.
TEST(Solid, ParityOfPlacedTrianglesBesideTheSurface) {
  RandomSource source(5);
  int inside = 0, outside = 0;
  for (int n = 0; n < 60; ++n) {
    const Mesh mesh = tests::random_tetrahedra(2, 1, source);
    const Pose pose = tests::distorted(tests::random_pose(n % 3 * 1e3, source), 9e-7, source);
    const PlacedMesh placed{mesh, pose};
    const Mesh there = baked(placed);
    const Triangle t = there.triangle(static_cast<std::size_t>(source.integer(0, 7)));
    for (const Eigen::Vector3d& on :
         {t.a, Eigen::Vector3d((t.a + t.b) / 2), Eigen::Vector3d((t.a + t.b) / 4 + t.c / 2)}) {
      for (int k = 0; k < 3; ++k) {
        for (const double side : {-HUGE_VAL, HUGE_VAL}) {
          Eigen::Vector3d point = on;
          point[k] = std::nextafter(point[k], side);
          if (intersects({there}, Aabb{point, point})) continue;
          Work work;
          const bool expected = contains_by_slanted_ray(there, point);
          ++(expected ? inside : outside);
          ASSERT_EQ(is_moved_point_enclosed(placed, point, work), expected) << n;
        }
      }
    }
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(outside, 100);
}

// A few doubles across, far from the origin in both frames: placing moves vertices by as much as
// the mesh is large, and the bounds that end the ray must hold them all the same.
TEST(Solid, ParityOfMeshesAFewDoublesAcross) {
  RandomSource source(8);
  int inside = 0;
  for (int n = 0; n < 150; ++n) {
    const Eigen::Vector3d centre = source.vector(-1e9, 1e9);
    // A box's corners fill the bounds of what is placed: these are as tight as can be.
    const Mesh shape =
        n % 3 == 0 ? tests::random_tetrahedra(1, 1, source) : tests::make_box({1, 1, 1});
    const Mesh mesh = tests::mapped(shape, 1e-6, centre);
    const Pose pose = tests::random_pose(1e9, source);
    const PlacedMesh placed{mesh, pose};
    const Mesh there = baked(placed);
    for (int i = 0; i < 20; ++i) {
      Eigen::Vector3d point;
      for (int k = 0; k < 3; ++k) {
        const auto vertex = static_cast<std::size_t>(source.integer(0, n % 3 == 0 ? 3 : 7));
        const double on = there.vertices()[vertex][k];
        const double side = source.integer(-1, 1);
        point[k] = side == 0 ? on : std::nextafter(on, side * HUGE_VAL);
      }
      if (intersects({there}, Aabb{point, point})) continue;
      Work work;
      const bool expected = contains_by_slanted_ray(there, point);
      inside += expected;
      ASSERT_EQ(is_moved_point_enclosed(placed, point, work), expected) << n;
    }
  }
  EXPECT_GT(inside, 50);
}

TEST(Solid, ABarThatIsTurnedReachesWhereItLies) {
  const Mesh bar = tests::make_box({4, 1, 2});
  Pose pose = Pose::Identity();
  pose.linear() << 0, 0, 1, 1, 0, 0, 0, 1, 0;  // x lies along y then, y along z, z along x
  const Mesh small = tests::make_box({0.1, 0.1, 0.1});
  for (const Eigen::Vector3d& end : {Eigen::Vector3d(0, 3.5, 0), Eigen::Vector3d(1.5, 0, 0)}) {
    EXPECT_TRUE(intersects({bar, pose}, {small, moved_by(end)}, kSolid));
    EXPECT_TRUE(intersects({bar, pose}, {small, moved_by(-end)}, kSolid));
    EXPECT_TRUE(intersects({bar, pose}, Aabb{end, end}, kSolidMesh));
  }
  EXPECT_FALSE(intersects({bar, pose}, {small, moved_by({3.5, 0, 0})}, kSolid));
}

TEST(Solid, BoxesAndBallsInsideAMesh) {
  const Mesh ball = tests::make_sphere(2, 30, 30);
  const PlacedMesh placed{ball, moved_by({5, 6, 7})};
  const Aabb box{{4.9, 5.9, 6.9}, {5.1, 6.1, 7.1}};
  const Aabb beside{{6.6, 7.6, 6.9}, {6.7, 7.7, 7.1}};
  RandomSource source(7);
  const Obb tilted{tests::random_pose(0, source), {0.1, 0.2, 0.3}};
  EXPECT_FALSE(intersects(placed, box));
  EXPECT_TRUE(intersects(placed, box, kSolidMesh));
  EXPECT_FALSE(intersects(placed, beside, kSolidMesh));
  EXPECT_TRUE(intersects(placed, Sphere{{5, 6, 7.5}, 0.5}, kSolidMesh));
  EXPECT_FALSE(intersects(placed, Sphere{{5, 6, 7.5}, 0.5}));
  EXPECT_FALSE(intersects(placed, Sphere{{9, 6, 7.5}, 0.5}, kSolidMesh));
  EXPECT_TRUE(intersects({ball}, tilted, kSolidMesh));
  EXPECT_FALSE(intersects({ball}, tilted));
  EXPECT_FALSE(intersects(placed, tilted, kSolidMesh));
}

TEST(Solid, RandomBoxesAgreeWithRationalsInTheirFrames) {
  RandomSource source(6);
  int inside = 0, outside = 0;
  for (int n = 0; n < 400; ++n) {
    const Mesh mesh = tests::random_tetrahedra(2, 1, source);
    const Pose pose = tests::random_pose(0.3, source);
    const PlacedMesh placed{mesh, pose};
    const double size = n % 2 == 0 ? 0.01 : 0;
    const Obb box{tests::random_pose(0.5, source), source.vector(0, 1) * size};
    if (intersects(placed, box)) continue;
    const Mesh framed = baked(placed, [&](const Eigen::Vector3d& p) {
      return narrowphase::point_into_frame(p, box.pose);
    });
    const bool expected = contains_by_slanted_ray(framed, Eigen::Vector3d::Zero());
    ++(expected ? inside : outside);
    ASSERT_EQ(intersects(placed, box, kSolidMesh), expected) << n;
  }
  EXPECT_GT(inside, 20);
  EXPECT_GT(outside, 100);
}

std::string message_of(const Mesh& a, const Mesh& b) {
  try {
    intersects({a}, {b}, kSolid);
  } catch (const MeshError& error) {
    return error.what();
  }
  return "";
}

TEST(Law10Solid, OpenMeshesAreRefusedAndNamed) {
  const Mesh box = tests::make_box({1, 1, 1});
  const Mesh open = tests::make_row(3);
  EXPECT_EQ(message_of(open, box),
            "mesh A is not closed: it has 9 boundary edges, the first from vertex 0 to "
            "vertex 1 of triangle 0");
  EXPECT_EQ(message_of(box, open),
            "mesh B is not closed: it has 9 boundary edges, the first from vertex 0 to "
            "vertex 1 of triangle 0");
  EXPECT_EQ(message_of(box, box), "");
  EXPECT_THROW(intersects({open}, Aabb{{0, 0, 0}, {1, 1, 1}}, kSolidMesh), MeshError);
  EXPECT_THROW(intersects({open}, Sphere{{0, 0, 0}, 1}, kSolidMesh), MeshError);
}

TEST(Law10Solid, SettingsThatMeanNothingAreRefused) {
  const Mesh box = tests::make_box({1, 1, 1});
  EXPECT_THROW(intersects({box}, {box}, {.hit = static_cast<Hit>(5)}), InputError);
  EXPECT_THROW(intersects({box}, Sphere{{0, 0, 0}, 1}, {.interior = static_cast<Interior>(5)}),
               InputError);
}

}  // namespace
}  // namespace graze
