// A field of a hundred million cells: what it takes, and that what is asked of it at any place is
// what a mesh of the cells around says.

#include <graze/engine/world/height_field.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shape_ray.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "tests/engine/motion/moving_bodies.h"

namespace graze {
namespace {

constexpr std::uint32_t kLargeSide = 10001;  // heights along each side
constexpr double kUnit = 1.0 / 64;           // metres of a stored height
constexpr std::uint32_t kAround = 8;         // cells on each side of a place

/// Slopes of whole numbers, and stones on them.
std::uint16_t stored_height(std::uint32_t column, std::uint32_t row) {
  const std::uint32_t valley = column % 512 < 256 ? column % 256 : 255 - column % 256;
  const std::uint32_t ridge = row % 256 < 128 ? row % 128 : 127 - row % 128;
  return static_cast<std::uint16_t>(valley + ridge + (column * 7 + row * 13) % 32);
}

HeightField hundred_million_cells() {
  std::vector<std::uint16_t> heights;
  heights.reserve(std::size_t{kLargeSide} * kLargeSide);
  for (std::uint32_t row = 0; row < kLargeSide; ++row)
    for (std::uint32_t column = 0; column < kLargeSide; ++column)
      heights.push_back(stored_height(column, row));
  return HeightField(kLargeSide, kLargeSide, std::span<const std::uint16_t>(heights),
                     {.height_scale = kUnit});
}

/// The cells around a place, where they are in the field, and their numbers there.
struct Around {
  Mesh mesh;
  std::vector<std::uint32_t> numbers;  // of triangles in the field, by those of the mesh
};

Around cells_around(std::uint32_t column, std::uint32_t row) {
  const auto first = [](std::uint32_t at) { return at < kAround ? 0 : at - kAround; };
  const std::uint32_t left = first(column), low = first(row);
  const std::uint32_t right = std::min(column + kAround, kLargeSide - 1);
  const std::uint32_t high = std::min(row + kAround, kLargeSide - 1);
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t r = low; r <= high; ++r)
    for (std::uint32_t c = left; c <= right; ++c)
      vertices.emplace_back(c, r, stored_height(c, r) * kUnit);
  const std::uint32_t wide = right - left + 1;
  for (std::uint32_t r = low; r < high; ++r) {
    for (std::uint32_t c = left; c < right; ++c) {
      const std::uint32_t at = (r - low) * wide + (c - left);
      triangles.push_back({at, at + 1, at + wide + 1});
      triangles.push_back({at, at + wide + 1, at + wide});
      const std::uint32_t number = 2 * (r * (kLargeSide - 1) + c);
      numbers.insert(numbers.end(), {number, number + 1});
    }
  }
  return {Mesh(vertices, triangles), numbers};
}

double deepest(const Manifold& manifold) {
  double depth = 0;
  for (const ShapeContact& contact : manifold)
    depth = std::max(depth, contact.depth);
  return depth;
}

struct Place {
  std::uint32_t column, row;
};

/// The corners, and anywhere.
std::vector<Place> places(RandomSource& source, int count) {
  std::vector<Place> all{
      {0, 0}, {kLargeSide - 1, 0}, {0, kLargeSide - 1}, {kLargeSide - 1, kLargeSide - 1}};
  const auto at = [&] {
    return static_cast<std::uint32_t>(source.integer(0, static_cast<int>(kLargeSide) - 1));
  };
  for (int i = 0; i < count; ++i) {
    const std::uint32_t column = at();
    all.push_back({column, at()});
  }
  return all;
}

TEST(LargeFieldSlow, OfAHundredMillionCellsSaysWhatTheCellsAroundSay) {
  const HeightField heights = hundred_million_cells();
  constexpr double kCells = (kLargeSide - 1.0) * (kLargeSide - 1.0);
  EXPECT_LT(static_cast<double>(heights.bytes()) / kCells, 2.16);
  const Shape field = heights;
  RandomSource source(108);
  std::size_t hits = 0, rays = 0, met = 0;
  World world;
  const BodyId ground = world.add({field}, {.kind = BodyKind::Static});
  const std::vector<Place> all = places(source, 300);
  std::vector<Manifold> wanted;
  for (const Place& place : all) {
    const Around around = cells_around(place.column, place.row);
    const Shape mesh = around.mesh;
    Pose pose = tests::random_pose(source, 0);
    const double ground_here = stored_height(place.column, place.row) * kUnit;
    pose.translation() =
        Eigen::Vector3d{place.column + source.uniform(-1, 1), place.row + source.uniform(-1, 1),
                        ground_here + source.uniform(-0.2, 1.5)};
    const Shape body = tests::random_small_shape(source, static_cast<int>(source.integer(0, 5)));
    const bool is_hit = intersects({mesh}, {body, pose});
    EXPECT_EQ(intersects({field}, {body, pose}), is_hit);
    // What a distance is off by grows with the scale of the body and a triangle.
    EXPECT_NEAR(distance({field}, {body, pose}).distance, distance({mesh}, {body, pose}).distance,
                4 * kTouchTolerance);
    hits += is_hit;
    const Eigen::Vector3d way = source.vector(-1, 1) - Eigen::Vector3d(0, 0, 1.5);
    const Ray ray{pose.translation() + Eigen::Vector3d(0, 0, 2), way, 9};
    const auto of_field = cast_ray({field}, ray), of_mesh = cast_ray({mesh}, ray);
    ASSERT_EQ(of_field.has_value(), of_mesh.has_value());
    if (of_mesh) {
      EXPECT_EQ(of_field->distance, of_mesh->distance);
      EXPECT_EQ(of_field->normal, of_mesh->normal);
      EXPECT_EQ(of_field->triangle, around.numbers[of_mesh->triangle]);
      ++rays;
    }
    world.add({body, pose}, {.user_data = wanted.size()});
    wanted.push_back(find_contacts({mesh}, {body, pose}));
  }
  for (const BodyContact& contact : world.update().contacts) {
    if (contact.pair.a != ground) continue;
    Manifold& of_mesh = wanted[world.user_data(contact.pair.b)];
    EXPECT_EQ(contact.manifold.empty(), of_mesh.empty());
    EXPECT_NEAR(deepest(contact.manifold), deepest(of_mesh), 1e-5);
    of_mesh.clear();
    ++met;
  }
  for (const Manifold& of_mesh : wanted)
    EXPECT_TRUE(of_mesh.empty()) << "the world missed one that touches";
  EXPECT_EQ(met, hits);
  EXPECT_GT(hits, 60u);
  EXPECT_LT(hits, all.size());
  EXPECT_GT(rays, 150u);
}

}  // namespace
}  // namespace graze
