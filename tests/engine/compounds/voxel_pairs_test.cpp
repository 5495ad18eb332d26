// Pairs of bodies of which maps of voxels are one or both, beside every pair of parts asked by
// itself; and how many that takes.

#include <graze/engine/world/compound.h>
#include <graze/engine/world/shapes/shape_work.h>
#include <graze/engine/world/voxel_map.h>
#include <graze/engine/world/world.h>

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <vector>

#include "tests/engine/compounds/pieces.h"
#include "tests/engine/motion/moving_bodies.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

using tests::any_shape;

/// Voxels at random on both sides of where blocks meet, and a row of full ones.
VoxelMap some_map(RandomSource& source, double edge, int count) {
  VoxelMap map(VoxelGrid{Eigen::Vector3d::Constant(-16 * edge), edge, {32, 32, 32}});
  const auto at = [&] { return static_cast<std::uint16_t>(source.integer(9, 22)); };
  for (int i = 0; i < count; ++i) {
    const Voxel voxel{at(), at(), at()};
    map.add(std::vector{voxel});
  }
  map.add_block({12, 16, 16}, {19, 16, 16});
  return map;
}

/// A map, a compound of few or of many parts, or a shape; on a lattice, where many are as far as
/// each other, or anywhere.
void add_any(World& world, RandomSource& source, double spread) {
  const bool is_on_lattice = source.integer(0, 1) == 0;
  Pose pose = tests::random_pose(source, spread);
  if (is_on_lattice) {
    const Eigen::Vector3d place = 0.5 * source.lattice_point(-4, 4);
    pose = tests::at(place.x(), place.y(), place.z());
  }
  const auto filter = [&] {
    return Filter{.category = static_cast<std::uint32_t>(source.integer(1, 3)),
                  .mask = static_cast<std::uint32_t>(source.integer(1, 3))};
  };
  const BodySettings settings{.filter = source.integer(0, 2) == 0 ? filter() : Filter{}};
  switch (static_cast<int>(source.integer(0, 5))) {
    case 0:
      world.add({any_shape(source), pose}, settings);
      return;
    case 1:
    case 2: {
      Compound compound;
      const auto parts = static_cast<int>(source.integer(0, 1) == 0 ? 5 : 30);
      for (int i = 0; i < parts; ++i) {
        const Eigen::Vector3d place = 0.25 * source.lattice_point(-3, 3);
        const PartSettings own{.filter = i % 4 == 1 ? std::optional(filter()) : std::nullopt};
        if (is_on_lattice) {
          compound.add(
              {Box{Eigen::Vector3d::Constant(0.125)}, tests::at(place.x(), place.y(), place.z())},
              own);
        } else {
          compound.add({any_shape(source), tests::random_pose(source, 1)}, own);
        }
      }
      world.add({share(compound), pose}, settings);
      return;
    }
    default:
      world.add({share(some_map(source, source.integer(0, 1) == 0 ? 0.125 : 0.07, 40)), pose},
                settings);
  }
}

TEST(VoxelPairs, AreThoseOfAllPiecesAskedAlone) {
  RandomSource source(79);
  std::size_t apart = 0, touching = 0;
  for (int round = 0; round < 80 && !HasFailure(); ++round) {
    World cell, robot;
    const double spread = round % 3 == 0 ? 8 : 1;
    for (int i = 0; i < 4; ++i)
      add_any(cell, source, spread);
    for (int i = 0; i < 2; ++i)
      add_any(robot, source, spread);
    const Pose pose = round % 2 == 0
                          ? tests::at(0.5 * source.integer(-3, 3), 0, round % 4 == 0 ? 0.25 : 3)
                          : tests::random_pose(source, round % 5 == 0 ? 20 : 2);
    const WorldPairSettings settings{.has_filters = round % 4 != 1};
    const double clearance = source.uniform(0, 2);
    const tests::Truth truth = tests::truth_of(cell, robot, pose, clearance, settings);
    EXPECT_EQ(cell.find_touching({robot, pose}, settings), truth.touching) << round;
    tests::expect_equal(cell.find_within({robot, pose}, clearance, settings), truth.within);
    EXPECT_EQ(cell.find_closest({robot, pose}, settings), truth.closest) << round;
    apart += truth.closest && truth.closest->distance.distance > 0;
    touching += truth.touching.size();
  }
  EXPECT_GT(apart, 15u);
  EXPECT_GT(touching, 15u);
}

/// Two plates of 65,536 voxels each, and a plate over 4,096 balls of a compound, whichever of the
/// two is A. Without the bounds of blocks the three take between 380,000 and 1.2 million.
TEST(VoxelPairs, FewAreMeasuredOfManyThatLieAlongEachOther) {
  const double edge = 0.125;
  VoxelMap plate(VoxelGrid{{-16, -16, 0}, edge, {256, 256, 1}});
  plate.add_block({0, 0, 0}, {255, 255, 0});
  VoxelMap bump = plate;
  bump.remove(std::vector<Voxel>{{40, 50, 0}});
  Compound tiles;
  for (int x = 0; x < 64; ++x) {
    for (int y = 0; y < 64; ++y)
      tiles.add({Sphere{{0, 0, 0}, 0.25}, tests::at(0.5 * x - 16, 0.5 * y - 16, 0)});
  }
  const auto tested = [&](const std::shared_ptr<const BodyShape>& a,
                          const std::shared_ptr<const BodyShape>& b) {
    World world;
    // Both at a slant, so that the box of each holds the other.
    Pose slant = Pose::Identity();
    slant.linear() = Eigen::AngleAxisd(0.9, Eigen::Vector3d(2, 1, 2) / 3).toRotationMatrix();
    world.add({a, slant});
    Pose over = Pose::Identity();
    over.linear() = Eigen::AngleAxisd(0.01, Eigen::Vector3d(0.6, 0.8, 0)).toRotationMatrix();
    over.translation() = Eigen::Vector3d(0.03, 0.02, 2);
    world.add({b, slant * over});
    Work work;
    std::optional<BodyPairDistance> found;
    {
      const ShapeWorkScope scope(work);
      found = world.find_closest_pair();
    }
    EXPECT_TRUE(found && found->distance.distance > 1);
    return work.convex_tests;
  };
  const std::uint64_t of_plates = tested(share(plate), share(bump));
  EXPECT_GT(of_plates, 10u);
  EXPECT_LE(of_plates, 200000u);
  EXPECT_LE(tested(share(plate), share(tiles)), 200000u);
  EXPECT_LE(tested(share(tiles), share(plate)), 200000u);
}

}  // namespace
}  // namespace graze
