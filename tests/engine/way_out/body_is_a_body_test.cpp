// Law 15: a polyhedron and the closed mesh of its surface have the same contacts, however that is
// tessellated. What convex shapes say to each other, which is proved by other means, is the truth.

#include <graze/engine/mesh/pair.h>
#include <graze/engine/world/convex_hull.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "tests/engine/way_out/tessellated.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;
using tests::random_pose;

/// How A lies beside B: in general position, or on top of it: turned about z, or aligned, and maybe
/// beyond the rim.
enum class Position { General, Turned, Aligned };

/// A above B where the two touch first, then sunk by so much, metres.
struct Sunk {
  Pose pose_a, pose_b;
  double sunk = 0;
};

std::optional<Sunk> sink(const Shape& a, const Shape& b, Position position, RandomSource& source) {
  Sunk found{Pose::Identity(), Pose::Identity(), std::pow(10, source.uniform(-4, -1)) * 0.2};
  Vector3d way = Vector3d::UnitZ(), start = Vector3d::Zero();
  if (position == Position::General) {
    found.pose_a = random_pose(0, source), found.pose_b = random_pose(3, source);
    way = source.vector(-1, 1).normalized();
  } else {
    const double turn = position == Position::Turned ? source.uniform(0, 6.28) : 0;
    const double quarters = source.integer(0, 3) * std::numbers::pi / 2;
    found.pose_a.linear() =
        (AngleAxisd(quarters, Vector3d::UnitX()) * AngleAxisd(turn, Vector3d::UnitZ()))
            .toRotationMatrix();
    start = Vector3d{source.uniform(-1.2, 1.2), source.uniform(-1.2, 1.2), 0};
  }
  const auto at = [&](double along) {
    Pose pose = found.pose_a;
    pose.translation() = found.pose_b * Vector3d(start + along * way);
    return pose;
  };
  double touching = 0, clear = 8;
  if (!intersects({a, at(0)}, {b, found.pose_b})) return std::nullopt;
  for (int step = 0; step < 50; ++step) {
    const double middle = 0.5 * (touching + clear);
    (intersects({a, at(middle)}, {b, found.pose_b}) ? touching : clear) = middle;
  }
  found.pose_a = at(touching - found.sunk);
  return found;
}

/// What the law allows: five hundredths of the depth, and for what is shallow the tolerance of
/// depths; a degree, or another way out that is as short.
void expect_same(const Manifold& found, const Manifold& truth, const Shape& a, const Shape& b,
                 const Sunk& sunk) {
  ASSERT_FALSE(found.empty());
  ASSERT_FALSE(truth.empty());
  ASSERT_EQ(found.region_count(), 1u) << "two convex bodies meet in one region";
  const double depth = truth[0].depth;
  // A manifold of shapes may lack 1e-4 of how far its contacts are spread (manifold.h).
  double spread = 0;
  for (const ShapeContact& contact : truth)
    spread = std::max(spread, (contact.point - truth[0].point).norm());
  ASSERT_NEAR(found[0].depth, depth, 0.05 * depth + 1e-6 + 1e-4 * spread);
  for (const ShapeContact& contact : found) {
    ASSERT_NEAR(contact.normal.norm(), 1, 1e-12);
    // Of two points that meet once the bodies are parted that is to 2^-17 of the size (manifold.h).
    ASSERT_LE((contact.point_a - contact.point_b - contact.depth * contact.normal).norm(), 0x1p-16);
    ASSERT_LE(contact.depth, found[0].depth);
    ASSERT_GE(contact.depth, 0);
  }
  const double one_degree = std::cos(std::numbers::pi / 180);
  if (found[0].normal.dot(truth[0].normal) > one_degree) return;
  Pose away = sunk.pose_a;
  away.translation() -= found[0].normal * (1.001 * found[0].depth + 1e-8);
  ASSERT_FALSE(intersects({a, away}, {b, sunk.pose_b})) << "another way that does not part them";
}

class BodyIsABody : public testing::TestWithParam<Position> {};

/// Each kind of shape and a box: once as Box, once as mesh.
TEST_P(BodyIsABody, Law15OfShapesOnMeshes) {
  RandomSource source(151);
  constexpr std::array kKinds = {ShapeKind::Sphere,    ShapeKind::Box,  ShapeKind::Capsule,
                                 ShapeKind::Cylinder,  ShapeKind::Cone, ShapeKind::Ellipsoid,
                                 ShapeKind::ConvexHull};
  int asked = 0;
  for (int n = 0; n < 60; ++n) {
    for (const ShapeKind kind : kKinds) {
      const Shape a = tests::random_shape(kind, 0.6, source);
      const Vector3d half{source.uniform(0.5, 1.5), source.uniform(0.5, 1.5), 1};
      const Mesh mesh = tests::tessellated_box(half, 1 << (n % 5));
      const std::optional<Sunk> sunk = sink(a, Box{half}, GetParam(), source);
      if (!sunk) continue;
      SCOPED_TRACE((std::ostringstream() << name_of(kind) << " " << n).str());
      const Manifold truth = find_contacts({a, sunk->pose_a}, {Box{half}, sunk->pose_b});
      const Manifold found = find_contacts({a, sunk->pose_a}, {mesh, sunk->pose_b});
      expect_same(found, truth, a, Box{half}, *sunk);
      if (HasFatalFailure()) return;
      ++asked;
    }
  }
  EXPECT_GT(asked, 300);
}

/// Two convex meshes, and the hulls of their vertices. And neither less nor more than the way out:
/// by 0.95 of it the two still meet, by 1.003 and a millionth of their size, a metre, they do not,
/// which the exact test of meshes says.
TEST_P(BodyIsABody, Law15OfMeshesOnMeshes) {
  RandomSource source(152);
  int asked = 0;
  for (int n = 0; n < 14; ++n) {
    for (const auto kind_a : tests::kConvexMeshKinds) {
      for (const auto kind_b : tests::kConvexMeshKinds) {
        const Mesh a = tests::convex_mesh(kind_a, n % 4, source);
        const Mesh b = tests::convex_mesh(kind_b, (n / 4 + n) % 4, source);
        const Shape hull_a = ConvexHull(a.vertices()), hull_b = ConvexHull(b.vertices());
        const std::optional<Sunk> sunk = sink(hull_a, hull_b, GetParam(), source);
        if (!sunk) continue;
        SCOPED_TRACE((std::ostringstream() << n << " kinds " << static_cast<int>(kind_a) << " "
                                           << static_cast<int>(kind_b))
                         .str());
        const Manifold truth = find_contacts({hull_a, sunk->pose_a}, {hull_b, sunk->pose_b});
        const Manifold found = find_contacts({Shape(a), sunk->pose_a}, {Shape(b), sunk->pose_b});
        expect_same(found, truth, hull_a, hull_b, *sunk);
        if (HasFatalFailure()) return;
        Pose away = sunk->pose_a;
        away.translation() =
            sunk->pose_a.translation() - (0.95 * found[0].depth - 2e-6) * found[0].normal;
        ASSERT_TRUE(intersects({a, away}, {b, sunk->pose_b}));
        away.translation() =
            sunk->pose_a.translation() - (1.003 * found[0].depth + 1e-6) * found[0].normal;
        ASSERT_FALSE(intersects({a, away}, {b, sunk->pose_b}));
        ++asked;
      }
    }
  }
  EXPECT_GT(asked, 180);
}

INSTANTIATE_TEST_SUITE_P(All, BodyIsABody,
                         testing::Values(Position::General, Position::Turned, Position::Aligned));

/// What leans on a flat face is deepest where it leans, so that contacts level it.
TEST(WayOut, Law15LeaningBodiesAreDeepestWhereTheyLean) {
  for (const int cells : {1, 2, 8}) {
    const Mesh table = tests::tessellated_box({2, 2, 0.5}, 4 * cells);
    const Mesh body = tests::tessellated_box({0.5, 0.5, 0.25}, cells);
    for (const double lean : {0.01, 0.035, 0.1}) {  // radians about y: +x goes down
      Pose pose(Eigen::Translation3d(0.0123, 0.0077, 0));
      pose.linear() = AngleAxisd(lean, Vector3d::UnitY()).toRotationMatrix();
      const double lowest = 0.5 * std::sin(lean) + 0.25 * std::cos(lean);
      pose.translation().z() = 0.5 + lowest - 0.02;
      for (const Shape& a : {Shape(body), Shape(Box{{0.5, 0.5, 0.25}})}) {
        const Manifold found = find_contacts({a, pose}, {table, Pose::Identity()});
        ASSERT_EQ(found.region_count(), 1u) << lean;
        EXPECT_NEAR(found[0].depth, 0.02, 1e-9);
        double moment = 0;
        for (const ShapeContact& contact : found) {
          EXPECT_NEAR((contact.normal - Vector3d(0, 0, -1)).norm(), 0, 1e-9);
          const double x = contact.point.x() - pose.translation().x();
          EXPECT_NEAR(contact.depth, 0.02 - (0.5 * std::cos(lean) - x) * std::tan(lean), 0.003);
          moment += contact.depth * x;
        }
        EXPECT_GT(moment, 0.005) << "turns the body back";
      }
    }
  }
}

/// One on the other, turned, tilted by up to 2e-3 and less than 1 mm deep: what crosses are long
/// edges, whose ends outside are as far along the way out as what is inside.
TEST(WayOut, Law15AtRestNothingIsLedSideways) {
  RandomSource source(1516);
  const std::vector<tests::ProfilePoint> drum = {{0, -0.15}, {0.2, -0.15}, {0.2, 0.15}, {0, 0.15}};
  const Mesh meshes[] = {tests::tessellated_box({0.2, 0.2, 0.15}, 1),
                         tests::tessellated_box({0.2, 0.2, 0.15}, 2),
                         tests::turned_profile(drum, 24, {1, 1})};
  for (const Mesh& mesh : meshes) {
    const Shape body = mesh, hull = ConvexHull(mesh.vertices());
    for (int n = 0; n < 1500; ++n) {
      Pose pose = Pose::Identity();
      const Vector3d about = Vector3d{source.uniform(-1, 1), source.uniform(-1, 1), 0}.normalized();
      const double lean = source.uniform(0, 2e-3), turn = source.uniform(-3, 3);
      pose.linear() =
          (AngleAxisd(lean, about) * AngleAxisd(turn, Vector3d::UnitZ())).toRotationMatrix();
      pose.translation() = Vector3d{source.uniform(-0.05, 0.05), source.uniform(-0.05, 0.05),
                                    0.3 - source.uniform(0, 1e-3)};
      const Manifold truth = find_contacts({hull}, {hull, pose});
      const Manifold found = find_contacts({body}, {body, pose});
      if (truth.empty() || found.empty()) continue;
      ASSERT_LE(found[0].depth, 1.05 * truth[0].depth + 1e-5)
          << n << " of " << mesh.triangles().size()
          << " triangles: " << found[0].normal.transpose();
    }
  }
}

}  // namespace
}  // namespace graze
