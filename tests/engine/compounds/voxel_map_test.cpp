// Maps of voxels: what is full, and what it meets beside a compound of the same boxes.

#include <graze/engine/mesh/voxels.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/voxel_map.h>
#include <graze/engine/world/world.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "tests/engine/compounds/twins.h"
#include "tests/engine/motion/moving_bodies.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

VoxelGrid grid_of(const Eigen::Vector3d& origin, double edge, std::uint32_t count) {
  return {origin, edge, {count, count, count}};
}

Voxel random_voxel(RandomSource& source, int most) {
  const auto at = [&] { return static_cast<std::uint16_t>(source.integer(0, most)); };
  const std::uint16_t i = at(), j = at(), k = at();
  return {i, j, k};
}

TEST(VoxelMap, HoldsWhatASetHolds) {
  RandomSource source(41);
  VoxelMap map(grid_of({1, 2, 3}, 0.25, 50));
  std::set<Voxel> full;
  for (int step = 0; step < 400; ++step) {
    const Voxel a = random_voxel(source, 49), b = random_voxel(source, 49);
    const Voxel first{std::min(a.i, b.i), std::min(a.j, b.j), std::min(a.k, b.k)};
    const auto end = [](std::uint16_t low, std::uint16_t high) {
      return std::min(high, static_cast<std::uint16_t>(low + 20));
    };
    const Voxel last{end(first.i, std::max(a.i, b.i)), end(first.j, std::max(a.j, b.j)),
                     end(first.k, std::max(a.k, b.k))};
    const bool is_added = source.uniform(0, 1) < 0.5;
    if (step % 2 == 0) {
      is_added ? map.add_block(first, last) : map.remove_block(first, last);
      for (std::uint16_t k = first.k; k <= last.k; ++k)
        for (std::uint16_t j = first.j; j <= last.j; ++j)
          for (std::uint16_t i = first.i; i <= last.i; ++i)
            is_added ? (void)full.insert({i, j, k}) : (void)full.erase({i, j, k});
    } else {
      const std::vector<Voxel> some{a, b, first};
      is_added ? map.add(some) : map.remove(some);
      for (const Voxel& voxel : some)
        is_added ? (void)full.insert(voxel) : (void)full.erase(voxel);
    }
    ASSERT_EQ(map.size(), full.size());
    EXPECT_EQ(map.contains(a), full.contains(a));
  }
  EXPECT_EQ(map.voxels(), std::vector<Voxel>(full.begin(), full.end()));
  std::set<std::uint32_t> numbers;
  for (const Voxel& voxel : full) {
    EXPECT_EQ(map.voxel(map.part(voxel)), voxel);
    numbers.insert(map.part(voxel));
  }
  EXPECT_EQ(numbers.size(), full.size());
}

/// A world with a map and one with a compound of its boxes, numbered alike in their orders.
struct Alike {
  VoxelMap map;
  std::vector<std::uint32_t> numbers;  ///< of the map, by those of the compound
  World of_map, of_boxes;

  explicit Alike(const VoxelMap& voxels, const Pose& pose) : map(voxels) {
    for (const Voxel& voxel : map.voxels())
      numbers.push_back(map.part(voxel));
    std::sort(numbers.begin(), numbers.end());
    Compound boxes;
    for (const std::uint32_t number : numbers)
      boxes.add({map.box(), map.pose(number)});
    of_map.add({share(map), pose}, {.kind = BodyKind::Static});
    of_boxes.add({share(boxes), pose}, {.kind = BodyKind::Static});
  }
  std::uint32_t number(BodyId id, std::uint32_t part) const {
    return id.index == 0 ? numbers[part] : part;
  }
};

std::size_t expect_alike(const Alike& worlds, std::vector<BodyContact> found,
                         std::vector<BodyContact> wanted) {
  EXPECT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < std::min(found.size(), wanted.size()); ++i) {
    Manifold& manifold = wanted[i].manifold;
    manifold.set_parts(worlds.number(wanted[i].pair.a, manifold.part_a()),
                       worlds.number(wanted[i].pair.b, manifold.part_b()));
    EXPECT_TRUE(found[i] == wanted[i]) << i;
  }
  return found.size();
}

std::size_t ask_both(Alike& worlds, const Shape& shape, const Pose& pose, double clearance,
                     RandomSource& source) {
  std::size_t answers = 0;
  EXPECT_EQ(worlds.of_map.find_touching({shape, pose}),
            worlds.of_boxes.find_touching({shape, pose}));
  auto near = worlds.of_boxes.find_within({shape, pose}, clearance);
  for (BodyDistance& each : near)
    each.part = worlds.number(each.id, each.part);
  EXPECT_TRUE(worlds.of_map.find_within({shape, pose}, clearance) == near);
  auto closest = worlds.of_boxes.find_closest({shape, pose});
  closest->part = worlds.number(closest->id, closest->part);
  EXPECT_TRUE(worlds.of_map.find_closest({shape, pose}) == closest);
  const Eigen::Vector3d from = pose.translation(), to = source.vector(-2, 2);
  auto hits = worlds.of_boxes.cast_ray_all({from, to - from});
  for (BodyRayHit& hit : hits)
    hit.part = worlds.number(hit.id, hit.part);
  EXPECT_TRUE(worlds.of_map.cast_ray_all({from, to - from}) == hits);
  const RigidMotion motion = RigidMotion::between(pose, tests::random_pose(source, 2));
  auto casts = worlds.of_boxes.cast_all({shape, motion});
  for (BodyCast& cast : casts)
    cast.part = worlds.number(cast.id, cast.part);
  EXPECT_TRUE(worlds.of_map.cast_all({shape, motion}) == casts);
  answers += near.size() + hits.size() + casts.size();
  return answers;
}

VoxelMap some_voxels(RandomSource& source, const VoxelGrid& grid, int count) {
  VoxelMap map(grid);
  const int most = static_cast<int>(grid.counts[0]) - 1;
  for (int i = 0; i < count; ++i)
    map.add(std::vector{random_voxel(source, most)});
  return map;
}

TEST(VoxelMap, MeetsWhatACompoundOfItsBoxesMeets) {
  RandomSource source(42);
  std::size_t contacts = 0, answers = 0;
  for (int round = 0; round < 24; ++round) {
    const std::uint32_t count = round % 3 == 0 ? 7 : 40;
    const double edge = round % 2 == 0 ? 0.0625 : 0.1;
    const double half = edge * count / 2;
    const VoxelGrid grid = grid_of({-half, -half, -half}, edge, count);
    Pose pose = round % 4 == 0 ? tests::at(0) : tests::random_pose(source, 1);
    Alike worlds(some_voxels(source, grid, 300), pose);
    for (int i = 0; i < 12; ++i) {
      const Shape shape = tests::random_small_shape(source, i % 6);
      const Pose at = tests::random_pose(source, 2);
      worlds.of_map.add({shape, at}, {.margin = i % 2 == 0 ? 0.05 : 0});
      worlds.of_boxes.add({shape, at}, {.margin = i % 2 == 0 ? 0.05 : 0});
    }
    for (int step = 0; step < 3 && !HasFailure(); ++step) {
      const WorldUpdate found = worlds.of_map.update(), wanted = worlds.of_boxes.update();
      const auto list = [](std::span<const BodyContact> all) {
        return std::vector<BodyContact>(all.begin(), all.end());
      };
      contacts += expect_alike(worlds, list(found.contacts), list(wanted.contacts));
      EXPECT_EQ(worlds.of_map.pairs(), worlds.of_boxes.pairs());
      for (const BodyId id : worlds.of_map.bodies()) {
        if (id.index == 0) continue;
        const Pose next = tests::moved(source, worlds.of_map.pose(id), 0.3, 0.5);
        worlds.of_map.move(id, next);
        worlds.of_boxes.move(id, next);
      }
      const Shape asked = tests::random_small_shape(source, round % 6);
      const Pose asked_at = tests::random_pose(source, step == 0 ? 6 : 2);
      const double within = source.uniform(0, 1);
      answers += ask_both(worlds, asked, asked_at, within, source);
    }
  }
  EXPECT_GT(contacts, 300u);
  EXPECT_GT(answers, 50u);
}

/// Rays along planes between voxels and through edges, from near and far.
TEST(VoxelMap, RaysMissNoVoxel) {
  RandomSource source(43);
  const VoxelGrid grid = grid_of({-1, -1, -1}, 0.0625, 32);
  for (const bool is_turned : {false, true}) {
    const auto voxels = some_voxels(source, grid, 400);
    Alike worlds(voxels, is_turned ? tests::random_pose(source, 1) : tests::at(0));
    const Pose pose = worlds.of_map.pose(worlds.of_map.bodies()[0]);
    std::size_t met = 0;
    for (int i = 0; i < 600 && !HasFailure(); ++i) {
      const Eigen::Vector3d corner =
          pose *
          (source.lattice_point(-16, 16) * 0.0625 +
           (i % 3 == 0 ? Eigen::Vector3d(0.03125, 0.03125, 0.03125) : Eigen::Vector3d(0, 0, 0)));
      Eigen::Vector3d way = i % 2 == 0 ? Eigen::Vector3d(source.lattice_point(-1, 1))
                                       : Eigen::Vector3d(source.vector(-1, 1));
      if (way == Eigen::Vector3d(0, 0, 0)) way.x() = 1;
      way = pose.linear() * way;
      const double far = i % 5 == 0 ? 1e6 : 3;
      const Ray ray{corner - far * way, way};
      auto wanted = worlds.of_boxes.cast_ray(ray);
      if (wanted) wanted->part = worlds.number(wanted->id, wanted->part);
      EXPECT_TRUE(worlds.of_map.cast_ray(ray) == wanted) << i;
      met += wanted.has_value();
    }
    EXPECT_GT(met, 100u);
  }
}

/// Voxels of a mesh hold it: whatever touches the mesh touches one of them.
TEST(VoxelMap, OfAMeshHoldsTheMesh) {
  RandomSource source(44);
  const Mesh mesh = tests::random_soup({.count = 60}, source);
  const VoxelMap map(find_voxels({mesh}, {.resolution = 48}));
  World world;
  world.add({share(map), tests::at(0)});
  std::size_t touching = 0;
  for (int i = 0; i < 300; ++i) {
    const Shape ball = Sphere{{0, 0, 0}, source.uniform(0.001, 0.2)};
    const Pose at = tests::random_pose(source, 1);
    if (!intersects({ball, at}, {mesh})) continue;
    ++touching;
    EXPECT_EQ(world.find_touching({ball, at}).size(), 1u);
  }
  EXPECT_GT(touching, 30u);
}

TEST(VoxelMap, LooksAtVoxelsThatAreNearAlone) {
  VoxelMap map(grid_of({-512, -512, -1}, 1, 1024));
  map.add_block({0, 0, 0}, {1023, 1023, 0});
  World world;
  const BodyId floor = world.add({share(map), tests::at(0)}, {.kind = BodyKind::Static});
  world.add({Box{{0.4, 0.4, 0.4}}, tests::at(0.5, 0.5, 0.3)});
  const WorldUpdate update = world.update();
  ASSERT_EQ(update.contacts.size(), 1u);
  EXPECT_EQ(voxel_map_of(world.shape(floor))->voxel(update.contacts[0].manifold.part_a()),
            (Voxel{512, 512, 0}));
  EXPECT_LE(update.work.shapes.convex_tests + update.work.shapes.volume_tests, 20u);
  EXPECT_EQ(compound_of(world.shape(floor)), nullptr);
}

TEST(VoxelMap, WhatIsBadIsRefused) {
  EXPECT_THROW(VoxelMap(grid_of({0, 0, 0}, 0, 4)), InputError);
  EXPECT_THROW(VoxelMap(grid_of({0, 0, 0}, 1, 70000)), InputError);
  VoxelMap map(grid_of({0, 0, 0}, 1, 20));
  EXPECT_THROW(share(map), InputError) << "no voxels";
  EXPECT_THROW(map.add(std::vector<Voxel>{{1, 1, 1}, {1, 20, 1}}), InputError);
  EXPECT_TRUE(map.empty()) << "all or none";
  EXPECT_THROW(map.add_block({2, 0, 0}, {1, 5, 5}), InputError);
  EXPECT_THROW(map.remove_block({0, 0, 0}, {20, 5, 5}), InputError);
  EXPECT_THROW(map.part({1, 1, 1}), StaleIdError);
  EXPECT_THROW(map.voxel(0), StaleIdError);
  map.add_block({0, 0, 0}, {19, 19, 19});
  EXPECT_EQ(map.size(), 8000u);
  map.remove_block({0, 0, 0}, {19, 19, 19});
  EXPECT_TRUE(map.empty());
  EXPECT_THROW(map.pose(0), StaleIdError);
  map.add(std::vector<Voxel>{{3, 4, 5}});
  World world;
  EXPECT_THROW(world.add({share(map), tests::at(1e101)}), PoseError);
  VoxelMap far(grid_of({0.9e100, 0, 0}, 1e90, 4));
  far.add(std::vector<Voxel>{{0, 0, 0}});
  EXPECT_THROW(world.add({share(far), tests::at(0.9e100)}), PoseError);
  VoxelMap farther(grid_of({1.1e100, 0, 0}, 1e90, 4));
  farther.add(std::vector<Voxel>{{0, 0, 0}});
  EXPECT_THROW(share(farther), PoseError);
}

}  // namespace
}  // namespace graze
