// Law 15 where a mesh has one side: what is behind its surface by no more than rounding, and what
// is in front of its corners.

#include <graze/engine/world/convex_hull.h>
#include <graze/engine/world/height_field.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/world.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <vector>

#include "tests/engine/way_out/tessellated.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;

/// A tetrahedron whose apex is up.
const std::vector<Vector3d> kPyramid{
    {0, 0, 0.5}, {0.5, 0, -0.5}, {0, 0.5, -0.5}, {-0.5, -0.5, -0.5}};
const std::vector<TriangleIndices> kPyramidFaces{{1, 3, 2}, {0, 1, 2}, {0, 2, 3}, {0, 3, 1}};

// However near what is behind comes to the surface, it leaves in front of it by all of its height.
TEST(BodySide, WhatIsBehindByAHairIsBehind) {
  const MeshSides sides = MeshSides::one_sided(1);
  const Shape sheet =
      HeightField(2, 2, std::vector<float>(4, 1.f), {.spacing_x = 4, .spacing_y = 4});
  RandomSource source(1521);
  for (const Shape& solid : {Shape(tests::tessellated_box({4, 4, 1}, 1)), sheet}) {
    for (const Shape& body :
         {Shape(Sphere{{0, 0, 0}, 0.5}), Shape(Box{{0.5, 0.5, 0.5}}), Shape(Capsule{0.25, 0.25}),
          Shape(Cone{0.3, 0.5}), Shape(Cylinder{0.3, 0.5}),
          Shape(Ellipsoid{{0, 0, 0}, {0.3, 0.4, 0.5}}), Shape(ConvexHull(kPyramid)),
          Shape(Mesh(kPyramid, kPyramidFaces)),
          Shape(tests::tessellated_box({0.5, 0.5, 0.5}, 1))}) {
      int asked = 0;
      for (int bits = 53; bits >= 24; --bits) {
        SCOPED_TRACE((std::ostringstream() << name_of(body.kind()) << " " << bits).str());
        // What does not touch the surface is behind it, as its middle is.
        for (const Pose& frame : {Pose::Identity(), tests::random_pose(1, source)}) {
          const Pose pose = frame * tests::at(2.1, 2.2, 0.5 - std::ldexp(1, -bits));
          if (intersects({solid, frame}, {body, pose})) continue;
          ++asked;
          for (const double margin : {0.0, 0.125}) {
            const Manifold found =
                find_contacts({solid, frame}, {body, pose}, {.margin = margin, .sides_a = sides});
            ASSERT_FALSE(found.empty());
            EXPECT_NEAR(found[0].depth, 1, 1e-6);
          }
          World world;
          world.add({solid, frame}, {.kind = BodyKind::Static, .sides = sides});
          world.add({body, pose});
          EXPECT_EQ(world.update().begun.size(), 1u);
        }
      }
      EXPECT_GE(asked, 8) << name_of(body.kind());
    }
  }
}

// Rounding may bring the nearest points of flush faces together, or to wrong sides, most of all
// where edges lie on edges. On which side the bodies are is known, as neither touches the surface.
TEST(BodySide, FacesAndTipsAHairApartAreOnTheirSides) {
  const MeshSides sides = MeshSides::one_sided(0.3);
  const Shape floor = tests::tessellated_box({4, 4, 1}, 8);
  RandomSource source(1522);
  int over_count = 0, under_count = 0;
  for (const Shape& body :
       {Shape(Box{{0.5, 0.5, 0.5}}), Shape(tests::tessellated_box({0.5, 0.5, 0.5}, 1)),
        Shape(Mesh(kPyramid, kPyramidFaces)), Shape(ConvexHull(kPyramid))}) {
    const bool has_apex = body.kind() == ShapeKind::ConvexHull ||
                          (body.as<Mesh>() != nullptr && body.as<Mesh>()->vertices().size() == 4);
    for (int n = 0; n < 400; ++n) {
      const Pose frame = tests::random_pose(1, source);
      // Hulls that are nearer than a tolerance touch.
      const int least = body.kind() == ShapeKind::ConvexHull ? -30 : -53;
      const double hair = std::ldexp(1, least + n % 8), x = 0.25 * (n % 5), y = 0.5 * (n % 3);
      Pose over = tests::at(x, y, 1.5 + hair);
      if (has_apex) over.linear() = Vector3d(1, -1, -1).asDiagonal();
      const Pose under = tests::at(x, y, 0.5 - hair);
      SCOPED_TRACE((std::ostringstream() << name_of(body.kind()) << " " << n).str());
      if (!intersects({floor, frame}, {body, frame * over})) {
        EXPECT_TRUE(
            find_contacts({floor, frame}, {body, frame * over}, {.sides_a = sides}).empty());
        ++over_count;
      }
      if (!intersects({floor, frame}, {body, frame * under})) {
        EXPECT_FALSE(
            find_contacts({floor, frame}, {body, frame * under}, {.sides_a = sides}).empty());
        ++under_count;
      }
    }
  }
  EXPECT_GT(over_count, 1000);
  EXPECT_GT(under_count, 1000);
}

// Where edges lie on edges, rounding may turn the line between the nearest points to the other
// side. A box that does not touch the sheet is on the side on which its middle is.
TEST(BodySide, WhatHasItsEdgesOnARimIsOnItsSide) {
  const std::vector<Vector3d> corners{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  const std::vector<TriangleIndices> triangles{{0, 1, 2}, {0, 2, 3}};
  const Shape sheet = Mesh(corners, triangles);
  const Shape box = Box{{1, 1, 0.25}};
  const MeshSides sides = MeshSides::one_sided(1);
  RandomSource source(1524);
  int over_count = 0, under_count = 0;
  for (int n = 0; n < 2000; ++n) {
    const Pose frame = tests::random_pose(1, source);
    const double hair = std::ldexp(1, -53);
    const Pose over = frame * tests::at(0, 0, 0.25 + hair);
    if (!intersects({sheet, frame}, {box, over})) {
      ++over_count;
      EXPECT_TRUE(find_contacts({sheet, frame}, {box, over}, {.sides_a = sides}).empty()) << n;
    }
    const Pose under = frame * tests::at(0, 0, -0.25 - hair);
    if (!intersects({sheet, frame}, {box, under})) {
      ++under_count;
      const Manifold found = find_contacts({sheet, frame}, {box, under}, {.sides_a = sides});
      ASSERT_FALSE(found.empty()) << n;
      EXPECT_NEAR(found[0].depth, 0.5, 1e-9) << n;
      EXPECT_LT((found[0].normal - frame.linear().col(2)).norm(), 1e-9) << n;
    }
  }
  EXPECT_GT(over_count, 400);
  EXPECT_GT(under_count, 400);
}

// What has no inside is on the side of the floor's plane on which all of its corners are, exactly.
TEST(BodySide, SheetsAHairApartAreOnTheirSides) {
  const MeshSides sides = MeshSides::one_sided(0.3);
  RandomSource source(1523);
  int behind = 0, in_front = 0;
  for (int n = 0; n < 3000; ++n) {
    const Pose frame = tests::random_pose(1, source);
    const double height = std::ldexp(n % 2 == 0 ? 1 : -1, -53 + n % 5);
    const auto placed = [&](double x, double y, double z) { return frame * Vector3d(x, y, z); };
    const std::vector<Vector3d> floor{placed(-4, -4, 0), placed(8, -4, 0), placed(-4, 8, 0)};
    const std::vector<Vector3d> sheet{placed(0, 0, height), placed(0.5, 0, height),
                                      placed(0.1 + 0.1 * (n % 3), 0.75, height)};
    int above = 0;
    for (const Vector3d& corner : sheet)
      above += static_cast<int>(narrowphase::orientation_3d(floor[0].data(), floor[1].data(),
                                                            floor[2].data(), corner.data()));
    if (std::abs(above) != 3) continue;
    const std::vector<TriangleIndices> one{{0, 1, 2}};
    SCOPED_TRACE(n);
    EXPECT_EQ(
        find_contacts({Shape(Mesh(floor, one))}, {Shape(Mesh(sheet, one))}, {.sides_a = sides})
            .empty(),
        above > 0);
    ++(above > 0 ? in_front : behind);
  }
  EXPECT_GT(behind, 1000);
  EXPECT_GT(in_front, 1000);
}

// A corner's normals count by their angles: many slivers on one of its sides count as one triangle.
TEST(BodySide, WhatIsInFrontOfACornerIsInFrontHoweverItIsTessellated) {
  const MeshSides sides = MeshSides::one_sided(0.3);
  const Vector3d base[] = {{1, 0, -4}, {-0.5, std::sqrt(0.75), -4}, {-0.5, -std::sqrt(0.75), -4}};
  for (const int slivers : {1, 3, 20}) {
    std::vector<Vector3d> vertices{{0, 0, 0}, base[1], base[2]};
    for (int n = 0; n < slivers; ++n)
      vertices.push_back(base[0] + (base[1] - base[0]) * (static_cast<double>(n) / slivers));
    std::vector<TriangleIndices> faces{{0, 1, 2}, {0, 2, 3}};
    for (int n = 0; n < slivers; ++n) {
      const auto first = static_cast<std::uint32_t>(3 + n);
      faces.push_back({0, first, n + 1 == slivers ? 1 : first + 1});
    }
    const Shape spike = Mesh(vertices, faces);
    // Each side's normal, and up: where the apex is the nearest point.
    for (const double angle : {60., 180., 300.}) {
      const double turn = angle * 0.017453292519943295;
      const Vector3d away = Vector3d(std::cos(turn), std::sin(turn), 0.3).normalized();
      const Pose front = tests::at(0.1 * away[0], 0.1 * away[1], 0.1 * away[2]);
      EXPECT_TRUE(
          find_contacts({spike}, {Sphere{{0, 0, 0}, 0.05}, front}, {.sides_a = sides}).empty())
          << slivers << " " << angle;
    }
    EXPECT_FALSE(
        find_contacts({spike}, {Sphere{{0, 0, 0}, 0.05}, tests::at(0, 0, -2)}, {.sides_a = sides})
            .empty());
  }
}

/// A plate over [-2, 2]^2 whose front is up.
Mesh plate_of(std::uint32_t cells) {
  std::vector<Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (std::uint32_t j = 0; j <= cells; ++j) {
    for (std::uint32_t i = 0; i <= cells; ++i)
      vertices.push_back({4.0 * i / cells - 2, 4.0 * j / cells - 2, 0});
  }
  for (std::uint32_t j = 0; j < cells; ++j) {
    for (std::uint32_t i = 0; i < cells; ++i) {
      const std::uint32_t at = j * (cells + 1) + i, beyond = at + cells + 1;
      triangles.push_back({at, at + 1, beyond + 1});
      triangles.push_back({at, beyond + 1, beyond});
    }
  }
  return Mesh(vertices, triangles);
}

// Near a border the way straight ahead may be shorter than that in front. It is as long as it says,
// though the body touches nothing on it, and has an end: what is beyond the border is behind
// nothing.
TEST(BodySide, WhatIsUnderABorderLeavesAheadOrInFront) {
  const MeshSides sides = MeshSides::one_sided(1);
  for (const std::uint32_t cells : {1u, 2u, 5u}) {
    const Shape plate = plate_of(cells);
    for (const Shape& body : {Shape(Sphere{{0, 0, 0}, 0.25}), Shape(Box{{0.25, 0.25, 0.25}}),
                              Shape(tests::tessellated_box({0.25, 0.25, 0.25}, 2))}) {
      for (const double x : {0.0, 1.3, 1.8, 1.95, 2.05, 2.2, 2.3, 2.9}) {
        for (const double z : {-0.26, -0.375, -0.625, -0.9375}) {
          SCOPED_TRACE(
              (std::ostringstream() << cells << " " << name_of(body.kind()) << " " << x << " " << z)
                  .str());
          const double in_front = 0.25 - z, ahead = 2.25 - x;
          const Pose pose = tests::at(x, 0.125, z);
          const Manifold found = find_contacts({body, pose}, {plate}, {.sides_b = sides});
          ASSERT_EQ(found.empty(), ahead < 0);
          if (found.empty()) continue;
          EXPECT_NEAR(found[0].depth, std::min(in_front, ahead), 1e-9);
          const Vector3d out = in_front < ahead ? Vector3d{0, 0, 1} : Vector3d{1, 0, 0};
          EXPECT_NEAR((found[0].normal + out).norm(), 0, 1e-9);
          EXPECT_NEAR((found[0].point_a - found[0].point_b).dot(-out), found[0].depth, 1e-9);
          Pose after = pose;
          after.translation() += out * (1.001 * found[0].depth);
          EXPECT_TRUE(find_contacts({body, after}, {plate}, {.sides_b = sides}).empty());
        }
      }
    }
  }
}

/// Two cubes, of unlike sizes, beside each other.
Mesh two_cubes(double size) {
  std::vector<Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (const double half : {0.4 * size, -0.6 * size}) {
    const Mesh cube = tests::make_box(Vector3d::Constant(std::abs(half)));
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const Vector3d& v : cube.vertices())
      vertices.push_back(v + Vector3d(std::copysign(size, half), 0, 0));
    for (const TriangleIndices& t : cube.triangles())
      triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return {vertices, triangles};
}

// Where the body touches the border on its way ahead, it does so less deep than its way is long.
TEST(BodySide, WhatIsLedAheadIsBeyondTheBorder) {
  const MeshSides sides = MeshSides::one_sided(1);
  RandomSource source(1567);
  int ahead = 0;
  for (int n = 0; n < 2000; ++n) {
    const Shape plate = plate_of(1 + static_cast<std::uint32_t>(n) % 3);
    const Shape body = two_cubes(source.uniform(0.1, 0.3));
    Pose pose = tests::random_pose(0, source);
    const double x = source.uniform(1.6, 2.4), y = source.uniform(-1, 1);
    pose.translation() = Vector3d(x, y, source.uniform(-0.8, 0));
    if (intersects({body, pose}, {plate})) continue;
    const Manifold found = find_contacts({body, pose}, {plate}, {.sides_b = sides});
    if (found.empty() || found[0].normal.x() > -1 + 1e-9) continue;
    ++ahead;
    ASSERT_NEAR(found[0].depth, 2 + tests::reach_of(body, pose, -Vector3d::UnitX()), 1e-6) << n;
  }
  EXPECT_GT(ahead, 300);
}

// A large triangle's edge has no neighbour where two small ones lie along it, and ends no surface.
TEST(BodySide, WhatIsBeyondASeamIsBehindWhatGoesOnThere) {
  // Flat on one side of the seam, and rising on the other.
  const std::vector<Vector3d> vertices{{-2, -1, 0}, {0, -1, 0}, {0, 1, 0}, {-2, 1, 0},
                                       {0, 0, 0},   {2, -1, 2}, {2, 0, 2}, {2, 1, 2}};
  const std::vector<TriangleIndices> triangles{{0, 1, 2}, {0, 2, 3}, {1, 5, 6},
                                               {1, 6, 4}, {4, 6, 7}, {4, 7, 2}};
  const Shape crease = Mesh(vertices, triangles);
  for (const double x : {0.12, 0.15, 0.18}) {
    for (const double y : {-0.4, 0.3}) {
      const Manifold found = find_contacts({Sphere{{x, y, -0.2}, 0.1}}, {crease},
                                           {.sides_b = MeshSides::one_sided(1)});
      EXPECT_FALSE(found.empty()) << x << " " << y;
    }
  }
}

// Where the frame of a mesh lies says nothing about its size.
TEST(BodySide, TheFrameOfABodyMeansNothing) {
  constexpr double kFar = 1 << 20;
  const Shape ring = tests::make_torus(1.2, 0.6, 16, 10);
  const Mesh body = tests::make_box({0.25, 0.125, 0.0625});
  std::vector<Vector3d> vertices(body.vertices().begin(), body.vertices().end());
  for (Vector3d& vertex : vertices)
    vertex.x() += kFar;
  const Mesh far_body(vertices, body.triangles());
  RandomSource source(1527);
  int asked = 0;
  for (int n = 0; n < 500; ++n) {
    Vector3d at;
    for (int k = 0; k < 3; ++k)
      at[k] = std::round(source.uniform(-1.7, 1.7) * 1024) / 1024;
    const ManifoldSettings settings{.sides_b = MeshSides::solid()};
    const Pose pose = tests::at(at), far_pose = tests::at(at - Vector3d{kFar, 0, 0});
    const Manifold found = find_contacts({Shape(body), pose}, {ring}, settings);
    const Manifold other = find_contacts({Shape(far_body), far_pose}, {ring}, settings);
    ASSERT_EQ(found.empty(), other.empty());
    if (found.empty() || intersects({Shape(body), pose}, {ring})) continue;
    ++asked;
    ASSERT_NEAR(found[0].depth, other[0].depth, 1e-6) << n;
    ASSERT_NEAR((found[0].normal - other[0].normal).norm(), 0, 1e-6) << n;
  }
  EXPECT_GT(asked, 20);
}

}  // namespace
}  // namespace graze
