// Law 13 for meshes: what a walk finds beside each pair of triangles in rational arithmetic, and
// meshes of which the answer is known.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/mesh_cast.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/separating_translation.h>
#include <graze/narrowphase/cast.h>
#include <graze/narrowphase/triangle_distance.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/narrowphase/translation/rational_cast.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

constexpr CastSettings kLeft{.start = StartContact::IsLeft};

struct CastQuestion {
  PlacedMesh a;
  PlacedMesh b;
  Eigen::Vector3d displacement;
};

Triangle placed_triangle(const PlacedMesh& placed, std::uint32_t index) {
  return place(placed.pose, placed.mesh.triangle(index));
}

/// The earliest of all pairs, of equal ones the lowest.
struct ExactCast {
  oracle::RationalCast cast;
  TrianglePair pair{};
};

ExactCast each_with_each(const CastQuestion& q, StartContact start) {
  ExactCast first;
  for (std::uint32_t i = 0; i < q.a.mesh.triangles().size(); ++i) {
    for (std::uint32_t k = 0; k < q.b.mesh.triangles().size(); ++k) {
      const auto found = oracle::rational_cast(placed_triangle(q.a, i), placed_triangle(q.b, k),
                                               q.displacement, start);
      if (!found.contact) continue;
      if (!first.cast.contact || found.time < first.cast.time) first = {found, {i, k}};
    }
  }
  return first;
}

void expect_exact(const CastQuestion& q, StartContact start, int number) {
  const ExactCast right = each_with_each(q, start);
  const auto found = cast(q.a, q.b, q.displacement, {.start = start});
  ASSERT_EQ(found.has_value(), right.cast.contact.has_value()) << number;
  if (!found) return;
  EXPECT_EQ(found->time, right.cast.contact->time) << number;
  EXPECT_EQ(found->is_at_start, right.cast.contact->is_at_start) << number;
  EXPECT_EQ(found->pair, right.pair) << number;
  const auto mirrored = cast(q.b, q.a, -q.displacement, {.start = start});
  ASSERT_TRUE(mirrored) << number;
  EXPECT_EQ(mirrored->time, found->time) << number;
  EXPECT_EQ(mirrored->is_at_start, found->is_at_start) << number;
}

Triangle only(const Eigen::Vector3d& p) {
  return {p, p, p};
}

/// The features that are named meet at that time, at that point.
void expect_features(const CastQuestion& q, const MeshCast& found, double size) {
  const Triangle a = placed_triangle(q.a, found.pair.a), b = placed_triangle(q.b, found.pair.b);
  const Eigen::Vector3d corner_a[3] = {a.a, a.b, a.c}, corner_b[3] = {b.a, b.b, b.c};
  const std::uint32_t i = found.place_a, k = found.place_b;
  Triangle meets_a = a, meets_b = b;
  if (found.features == MeetingFeatures::VertexFace) meets_a = only(corner_a[i]);
  if (found.features == MeetingFeatures::FaceVertex) meets_b = only(corner_b[k]);
  if (found.features == MeetingFeatures::EdgeEdge) {
    meets_a = {corner_a[i], corner_a[(i + 1) % 3], corner_a[i]};
    meets_b = {corner_b[k], corner_b[(k + 1) % 3], corner_b[k]};
  }
  EXPECT_EQ(cast(meets_a, meets_b, q.displacement), (FirstContact{found.time, found.is_at_start}));
  const double near = 0x1p-48 * (size + q.displacement.norm());
  EXPECT_LE(distance(meets_a, only(found.point)).distance, near);
  EXPECT_LE(distance(meets_b, only(found.point - found.time * q.displacement)).distance, near);
  EXPECT_NEAR(found.normal.norm(), 1, 0x1p-50);
  EXPECT_LE(found.normal.dot(q.displacement), 0x1p-50 * q.displacement.norm());
}

TEST(Law13Meshes, AreEachTriangleWithEach) {
  RandomSource source(131);
  int later = 0;
  for (int n = 0; n < 30; ++n) {
    const CastQuestion q{
        {tests::random_soup({.count = 12, .size = 0.2}, source), tests::random_pose(0.5, source)},
        {tests::random_soup({.count = 12, .size = 0.2}, source), tests::random_pose(0.5, source)},
        source.vector(-2, 2)};
    for (const StartContact start : {StartContact::Counts, StartContact::IsLeft}) {
      expect_exact(q, start, n);
      const auto found = cast(q.a, q.b, q.displacement, {.start = start});
      later += found && !found->is_at_start;
      if (found && start == StartContact::Counts) expect_features(q, *found, 4);
    }
  }
  EXPECT_GT(later, 10);
}

TEST(Law13Meshes, AreExactOnLattices) {
  RandomSource source(132);
  int later = 0;
  for (int n = 0; n < 40; ++n) {
    CastQuestion q{{tests::lattice_soup(8, 3, source)},
                   {tests::lattice_soup(8, 3, source)},
                   source.lattice_point(-12, 12)};
    q.b.pose.translation() = source.lattice_point(-6, 6);
    for (const StartContact start : {StartContact::Counts, StartContact::IsLeft}) {
      expect_exact(q, start, n);
      const auto found = cast(q.a, q.b, q.displacement, {.start = start});
      later += found && !found->is_at_start;
      if (found && start == StartContact::Counts) expect_features(q, *found, 12);
    }
  }
  EXPECT_GT(later, 10);
}

/// A sheet of n by n squares over [0, 1]^2 at height 0.
Mesh flat_sheet(std::uint32_t n) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t k = 0; k <= n; ++k)
      vertices.emplace_back(double(i) / n, double(k) / n, 0);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t a = i * (n + 1) + k, b = a + n + 1;
      triangles.push_back({a, b, a + 1});
      triangles.push_back({a + 1, b, b + 1});
    }
  }
  return {vertices, triangles};
}

Mesh cube() {
  std::vector<Eigen::Vector3d> vertices;
  for (int i = 0; i < 8; ++i)
    vertices.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  return {vertices, std::vector<TriangleIndices>{{0, 2, 1},
                                                 {1, 2, 3},
                                                 {4, 5, 6},
                                                 {5, 7, 6},
                                                 {0, 1, 4},
                                                 {1, 5, 4},
                                                 {2, 6, 3},
                                                 {3, 6, 7},
                                                 {0, 4, 2},
                                                 {2, 4, 6},
                                                 {1, 3, 5},
                                                 {3, 7, 5}}};
}

Pose at_place(double x, double y, double z) {
  Pose pose = Pose::Identity();
  pose.translation() = Eigen::Vector3d(x, y, z);
  return pose;
}

TEST(Law13Meshes, LandFlatOnTheLowestPair) {
  const Mesh floor = flat_sheet(20);
  const auto landed = cast({floor}, {floor, at_place(0, 0, 0.5)}, {0, 0, -2});
  ASSERT_TRUE(landed);
  EXPECT_EQ(landed->time, 0.25);
  EXPECT_EQ(landed->pair, (TrianglePair{0, 0}));
  EXPECT_EQ(landed->normal, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(landed->point.z(), 0);
  const auto slid = cast({floor}, {floor, at_place(-1.5, 0, 0)}, {1, 0, 0});
  ASSERT_TRUE(slid);
  EXPECT_EQ(slid->time, 0.5);
  EXPECT_FALSE(cast({floor}, {floor, at_place(-1.5, 0, 0x1p-60)}, {1, 0, 0}));
}

// Rounding alone decides which pair of parallel faces is met first; level ones meet everywhere at
// once.
TEST(Law13Meshes, AreExactWhereParallelSheetsLand) {
  RandomSource source(137);
  for (int n = 0; n < 60; ++n) {
    const Pose turn = n % 3 == 0 ? Pose::Identity() : tests::random_pose(0, source);
    const auto sheet = [&](std::uint32_t side) {
      const Mesh flat = flat_sheet(side);
      std::vector<TriangleIndices> mixed(flat.triangles().begin(), flat.triangles().end());
      for (std::size_t i = mixed.size(); i > 1; --i)
        std::swap(mixed[i - 1], mixed[static_cast<std::size_t>(source.integer(0, int(i) - 1))]);
      return Mesh(flat.vertices(), mixed);
    };
    Pose above = turn;
    above.translation() = turn.linear() * Eigen::Vector3d(source.uniform(-0.5, 0.5), 0.125, 0.5);
    const Eigen::Vector3d down = turn.linear() * Eigen::Vector3d(source.uniform(-1, 1), 0, -1);
    expect_exact({{sheet(3), turn}, {sheet(2), above}, down}, StartContact::Counts, n);
  }
}

TEST(Law13Policy, ACubeMayLeaveAndSlideButNotSink) {
  const Mesh floor = flat_sheet(7), box = cube();
  const Pose resting = at_place(0.25, 0.25, 0);
  EXPECT_TRUE(cast({floor}, {box, resting}, {0, 0, 1})->is_at_start);
  EXPECT_FALSE(cast({floor}, {box, resting}, {0, 0, 1}, kLeft));
  // It may slide along what it touches; what comes next is met.
  const Mesh slab(std::vector<Eigen::Vector3d>{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}},
                  std::vector<TriangleIndices>{{0, 1, 2}});
  EXPECT_FALSE(cast({slab}, {box, resting}, {1, 2, 0}, kLeft));
  const auto next = cast({floor}, {box, at_place(-0.5, 0.25, 0)}, {1, 0, 0}, kLeft);
  ASSERT_TRUE(next);
  EXPECT_FALSE(next->is_at_start);
  EXPECT_LE(next->time, 1.0 / 7);
  const auto sinking = cast({floor}, {box, resting}, {5, 0, -1e-300}, kLeft);
  ASSERT_TRUE(sinking);
  EXPECT_TRUE(sinking->is_at_start);
  EXPECT_EQ(sinking->features, MeetingFeatures::AtStart);
  // What it comes to later is met as ever.
  const auto stopped = cast({box}, {box, at_place(-3, 0, 0)}, {4, 0, 0}, kLeft);
  ASSERT_TRUE(stopped);
  EXPECT_EQ(stopped->time, 0.5);
}

TEST(Law13Meshes, ScalingChangesNoTime) {
  RandomSource source(133);
  const Mesh mesh_a = tests::random_soup({.count = 40, .size = 0.2}, source);
  const Mesh mesh_b = tests::random_soup({.count = 40, .size = 0.2}, source);
  const Eigen::Vector3d d(-5, 0.25, 0.5);
  const auto found = cast({mesh_a}, {mesh_b, at_place(3, 0, 0)}, d);
  ASSERT_TRUE(found);
  for (const double scale : {0x1p900, 0x1p-900, 0x1p1018, 0x1p-1000}) {
    const auto scaled = [&](const Mesh& mesh) {
      std::vector<Eigen::Vector3d> vertices(mesh.vertices().begin(), mesh.vertices().end());
      for (Eigen::Vector3d& v : vertices)
        v = scale * v;
      return mesh.deformed(vertices);
    };
    const auto other =
        cast({scaled(mesh_a)}, {scaled(mesh_b), at_place(3 * scale, 0, 0)}, scale * d);
    ASSERT_TRUE(other) << scale;
    EXPECT_EQ(other->pair, found->pair);
    if (scale != 0x1p-1000) {
      EXPECT_EQ(other->time, found->time) << scale;
      EXPECT_EQ(other->point, scale * found->point) << scale;
    } else {
      EXPECT_NEAR(other->time, found->time, 1e-6);  // vertices are rounded there
    }
  }
  // Much longer and much shorter ways than the meshes are large.
  EXPECT_TRUE(cast({mesh_a}, {mesh_b, at_place(3, 0, 0)}, {-0x1p1000, 0, 0}));
  EXPECT_FALSE(cast({mesh_a}, {mesh_b, at_place(3, 0, 0)}, {-0x1p-1000, 0, 0}));
}

TEST(Law13Meshes, ASeparationLeadsBackToTheLastContact) {
  RandomSource source(134);
  for (int n = 0; n < 20; ++n) {
    const Mesh a = tests::random_soup({.count = 60, .size = 0.4}, source);
    const Mesh b = tests::random_soup({.count = 60, .size = 0.4}, source);
    const SeparatingTranslation apart = separating_translation({a}, {b}, source.vector(-1, 1));
    ASSERT_GT(apart.distance, 0);
    const auto back = cast({a}, {b, apart.pose_b}, -apart.translation);
    ASSERT_TRUE(back);
    EXPECT_LT(back->time, 1e-9);
    EXPECT_FALSE(cast({a}, {b, apart.pose_b}, 100 * apart.translation));
  }
}

TEST(Law13Meshes, LooksAtLittle) {
  const Mesh floor = flat_sheet(60);
  Work work;
  EXPECT_TRUE(cast({floor}, {cube(), at_place(0.3, 0.3, 2)}, {0.1, 0.2, -3}, {}, &work));
  EXPECT_GT(work.volume_tests, 0u);
  EXPECT_LT(work.triangle_tests, 7200u);
  Work none;
  EXPECT_FALSE(cast({floor}, {cube(), at_place(0.3, 0.3, 2)}, {0.1, 0.2, 3}, {}, &none));
  EXPECT_EQ(none.triangle_tests, 0u);
}

// Where flanks of teeth face each other, triangles' planes tell which of them are met later.
TEST(Law13Meshes, PlanesKeepOutWhatIsMetLater) {
  const Mesh gear = load_mesh(GRAZE_DATA_DIR "/meshes/gear.ply");
  const Mesh pinion = load_mesh(GRAZE_DATA_DIR "/meshes/pinion.off");
  const double reach = gear.bounds().max.norm() + pinion.bounds().max.norm();
  RandomSource source(136);
  Work work;
  for (int n = 0; n < 20; ++n) {
    Pose pose = tests::random_pose(0, source);
    const Eigen::Vector3d away = 2 * reach * source.vector(-1, 1);
    pose.translation() = away;
    cast({gear}, {pinion, pose}, -2 * away, {}, &work);
  }
  EXPECT_GT(work.triangle_tests, 0u);
  EXPECT_LT(3 * work.triangle_tests, work.filter_tests);
}

TEST(Law13Door, RefusesWhatItCannotPlace) {
  const Mesh box = cube();
  Pose skewed = Pose::Identity();
  skewed.matrix()(0, 1) = 1e-3;
  EXPECT_THROW(cast({box, skewed}, {box}, {1, 0, 0}), PoseError);
  EXPECT_THROW(cast({box}, {box, skewed}, {1, 0, 0}), PoseError);
  EXPECT_THROW(cast({box}, {box, at_place(0, 0x1.8p1023, 0)}, {1, 0, 0}), PoseError);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(cast({box}, {box}, {1, bad, 0}), InputError);
  EXPECT_THROW(cast({box}, {box}, {1, 0, 0}, {.start = static_cast<StartContact>(9)}), InputError);
}

}  // namespace
}  // namespace graze
