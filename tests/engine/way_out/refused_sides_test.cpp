// Sides that a mesh cannot honour.

#include <graze/bvh/error.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tests/engine/way_out/tessellated.h"

namespace graze {
namespace {

using Eigen::Vector3d;

constexpr MeshSides kSolidSides = MeshSides::solid();

/// Boxes with all of their triangles in one mesh; those of a negative size have their fronts
/// inside.
Mesh boxes_in_one(std::initializer_list<std::pair<Vector3d, double>> placed) {
  std::vector<Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (const auto& [centre, size] : placed) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    const double half = std::abs(size);
    const Mesh box = tests::tessellated_box({half, half, half}, 1);
    for (const Vector3d& vertex : box.vertices())
      vertices.push_back(vertex + centre);
    for (TriangleIndices triangle : box.triangles()) {
      if (size < 0) std::swap(triangle[0], triangle[1]);
      triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
    }
  }
  return Mesh(vertices, std::span<const TriangleIndices>(triangles));
}

TEST(Sides, WhatAMeshCannotHonourIsRefused) {
  const Mesh box = tests::tessellated_box({1, 1, 1}, 1);
  std::vector<TriangleIndices> open(box.triangles().begin(), box.triangles().end());
  std::vector<TriangleIndices> turned = open;
  open.pop_back();
  std::swap(turned[3][0], turned[3][1]);
  const Mesh open_box(box.vertices(), std::span<const TriangleIndices>(open));
  const Mesh turned_box(box.vertices(), std::span<const TriangleIndices>(turned));
  const Sphere ball{{0, 0, 0}, 0.1};
  const MeshSides one_sided = MeshSides::one_sided(0.1);
  EXPECT_NO_THROW(find_contacts({ball}, {Shape(box)}, {.sides_b = kSolidSides}));
  EXPECT_NO_THROW(find_contacts({ball}, {Shape(open_box)}, {.sides_b = one_sided}));
  EXPECT_THROW(find_contacts({ball}, {Shape(turned_box)}, {.sides_b = one_sided}), MeshError);
  try {
    find_contacts({ball}, {Shape(open_box)}, {.sides_b = kSolidSides});
    FAIL() << "an open mesh is no solid";
  } catch (const MeshError& error) {
    EXPECT_NE(std::string(error.what()).find("as many triangles one way as the other at each edge"),
              std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("the edge from vertex"), std::string::npos);
    EXPECT_TRUE(error.place().index.has_value());
  }
  EXPECT_THROW(find_contacts({ball}, {Shape(ball)}, {.sides_b = kSolidSides}), InputError);
  for (const double thickness : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::quiet_NaN()}) {
    const MeshSides sides = MeshSides::one_sided(thickness);
    EXPECT_THROW(find_contacts({ball}, {Shape(box)}, {.sides_b = sides}), InputError);
  }
  World world;
  EXPECT_THROW(world.add({Shape(open_box)}, {.sides = kSolidSides}), MeshError);
  const BodyId id = world.add({Shape(box)}, {.sides = kSolidSides});
  EXPECT_THROW(world.set_shape(id, ball), InputError);
  EXPECT_EQ(world.size(), 1u);
}

TEST(Sides, ASolidHasItsFrontsOutside) {
  const Sphere ball{{0, 0, 0}, 0.1};
  const Vector3d middle = Vector3d::Zero(), beside = {5, 0, 0}, near = {1.5, 0.25, 0.125};
  // A box, one in another's cavity, two apart, and two of which each has a part of the other.
  for (const Mesh& mesh :
       {boxes_in_one({{middle, 1}}), boxes_in_one({{middle, 2}, {middle, -1}, {middle, 0.5}}),
        boxes_in_one({{middle, 1}, {beside, 1}}), boxes_in_one({{middle, 1}, {near, 1}})})
    EXPECT_NO_THROW(find_contacts({ball}, {Shape(mesh)}, {.sides_b = kSolidSides}));
  // A cavity that touches its shell with a corner.
  std::vector<Vector3d> vertices{{1, 0, 0}, {-0.5, 0.4, 0}, {-0.5, -0.4, 0}, {0, 0, 0.4}};
  std::vector<TriangleIndices> triangles{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  const Mesh shell = boxes_in_one({{middle, 1}});
  for (const TriangleIndices& t : shell.triangles())
    triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
  vertices.insert(vertices.end(), shell.vertices().begin(), shell.vertices().end());
  const Mesh touched(vertices, std::span<const TriangleIndices>(triangles));
  // Beside it a box that is inside out: it is that box which is named.
  const Mesh faulty = boxes_in_one({{beside, -1}});
  std::vector<Vector3d> more = vertices;
  more.insert(more.end(), faulty.vertices().begin(), faulty.vertices().end());
  std::vector<TriangleIndices> of_more = triangles;
  const auto first = static_cast<std::uint32_t>(vertices.size());
  for (const TriangleIndices& t : faulty.triangles())
    of_more.push_back({t[0] + first, t[1] + first, t[2] + first});
  const Mesh touched_and_faulty(more, std::span<const TriangleIndices>(of_more));
  const Mesh turned(vertices, [&] {
    for (int i = 0; i < 4; ++i)
      std::swap(triangles[static_cast<std::size_t>(i)][0],
                triangles[static_cast<std::size_t>(i)][1]);
    return triangles;
  }());
  for (const Mesh& mesh : {touched, turned})
    EXPECT_NO_THROW(find_contacts({ball}, {Shape(mesh)}, {.sides_b = kSolidSides}));
  const auto expect_refused = [&](const Mesh& mesh, std::uint64_t triangle) {
    for (int i = 0; i < 2; ++i) {  // the second time it is known
      try {
        find_contacts({ball}, {Shape(mesh)}, {.sides_b = kSolidSides});
        ADD_FAILURE() << "a solid with its front inside at triangle " << triangle;
      } catch (const MeshError& error) {
        EXPECT_EQ(error.place().index, triangle);
        EXPECT_NE(std::string(error.what()).find("is inside out"), std::string::npos);
      }
    }
    World world;
    EXPECT_THROW(world.add({Shape(mesh)}, {.sides = kSolidSides}), MeshError);
  };
  expect_refused(boxes_in_one({{middle, -1}}), 0);
  expect_refused(touched_and_faulty, static_cast<std::uint64_t>(triangles.size()));
  expect_refused(boxes_in_one({{middle, 2}, {middle, 1}}), 12);  // no cavity
  expect_refused(boxes_in_one({{middle, -2}, {middle, 1}}), 0);
  expect_refused(boxes_in_one({{middle, 1}, {beside, -1}}), 12);
}

}  // namespace
}  // namespace graze
