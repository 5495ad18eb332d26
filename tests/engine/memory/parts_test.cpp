// What a compound holds for each part, a map of voxels for each block, and islands for each body
// and pair.

#include <graze/engine/world/compound.h>
#include <graze/engine/world/voxel_map.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include "tests/engine/body_world/allocations.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

TEST(CompoundMemory, IsWhatThePageSays) {
  constexpr int kParts = 10000;
  Compound compound;
  for (int i = 0; i < kParts; ++i)
    compound.add({Box{{0.5, 0.5, 0.5}}, tests::at(i % 100, i / 100)});
  const auto before = static_cast<double>(tests::allocated_bytes());
  const auto shared = share(compound);
  const double bytes = (static_cast<double>(tests::allocated_bytes()) - before) / kParts;
  EXPECT_LE(bytes, 512);
  EXPECT_GE(bytes, 250) << "a shape, a pose and two boxes alone take as much";
}

TEST(CompoundMemory, IsNoMoreForFewParts) {
  Compound compound;
  for (int i = 0; i < 4; ++i)
    compound.add({Box{{0.5, 0.5, 0.5}}, tests::at(i)});
  const auto before = static_cast<double>(tests::allocated_bytes());
  const auto shared = share(compound);
  EXPECT_LE(static_cast<double>(tests::allocated_bytes()) - before, 4 * 512 + 512);
}

TEST(VoxelMapMemory, IsWhatThePageSays) {
  const VoxelGrid grid{{-512, -512, -8}, 1, {1024, 1024, 16}};
  const auto before = static_cast<double>(tests::allocated_bytes());
  VoxelMap map(grid);
  map.add_block({0, 0, 0}, {1023, 1023, 0});
  constexpr double kBlocks = 64 * 64;
  // The list of blocks may have twice the room that it needs.
  const double own = (static_cast<double>(tests::allocated_bytes()) - before) / kBlocks;
  EXPECT_GE(own, 512);
  EXPECT_LE(own, 1200);
  const auto between = static_cast<double>(tests::allocated_bytes());
  const auto shared = share(map);
  EXPECT_LE((static_cast<double>(tests::allocated_bytes()) - between) / kBlocks, 800);
}

/// A floor of boxes, each of which touches its four neighbours, and no more.
double held_by_floor(bool has_islands) {
  const auto before = static_cast<double>(tests::allocated_bytes());
  World world({.contacts = false, .islands = has_islands});
  for (int i = 0; i < 10000; ++i)
    world.add({Sphere{{0, 0, 0}, 0.51}, tests::at(i % 100, i / 100)});
  world.update();
  return static_cast<double>(tests::allocated_bytes()) - before;
}

TEST(IslandMemory, IsWhatThePageSays) {
  const double bytes = held_by_floor(true) - held_by_floor(false);
  constexpr double kBodies = 10000, kPairs = 19800;
  const double own = 36 * kBodies + 24 * kPairs;
  EXPECT_GE(bytes, own);
  EXPECT_LE(bytes, 2 * (own + 4 * kBodies + 8 * kPairs)) << "and lists of what an update adds";
}

}  // namespace
}  // namespace graze
