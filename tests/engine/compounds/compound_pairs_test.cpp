// The nearest two parts of compounds of very many parts, beside every pair of parts; and how few of
// them are measured.

#include <graze/engine/world/compound.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shapes/shape_work.h>
#include <graze/engine/world/world.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "tests/engine/motion/moving_bodies.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

/// The nearest pair, of equals the first. What boxes part by more than that need not be measured:
/// distance() never says less than they do.
struct Nearest {
  ShapeDistance distance;
  std::uint32_t part_a, part_b;
};

Nearest nearest_of_all(const Compound& a, const Pose& pose_a, const Compound& b,
                       const Pose& pose_b) {
  struct Part {
    std::uint32_t number;
    PlacedShape placed;
    Aabb box;
  };
  const auto parts_of = [](const Compound& compound, const Pose& pose) {
    std::vector<Part> parts;
    for (const std::uint32_t number : compound.parts()) {
      const PlacedShape& part = compound.part(number);
      const PlacedShape placed{part.shape, placed_part(pose, part.pose)};
      parts.push_back({number, placed, bounding_aabb(placed)});
    }
    return parts;
  };
  const std::vector<Part> parts_a = parts_of(a, pose_a), parts_b = parts_of(b, pose_b);
  std::optional<Nearest> best;
  for (const Part& s : parts_a) {
    for (const Part& t : parts_b) {
      double gap = 0;
      for (int k = 0; k < 3; ++k)
        gap = std::max({gap, s.box.min[k] - t.box.max[k], t.box.min[k] - s.box.max[k]});
      if (best && gap * (1 - 0x1p-40) > best->distance.distance) continue;
      const ShapeDistance found = distance(s.placed, t.placed);
      if (!best || found.distance < best->distance.distance) best = {found, s.number, t.number};
    }
  }
  return *best;
}

/// Parts of all kinds anywhere in a ball, some numbers free; or boxes on a lattice, where many are
/// as far as each other.
Compound random_parts(RandomSource& source, int count, bool is_on_lattice) {
  Compound compound;
  for (int i = 0; i < count; ++i) {
    if (is_on_lattice) {
      const Eigen::Vector3d place = 0.25 * source.lattice_point(-6, 6);
      compound.add(
          {Box{Eigen::Vector3d::Constant(0.0625)}, tests::at(place.x(), place.y(), place.z())});
    } else {
      const Eigen::Vector3d place = source.vector(-3, 3);
      Pose pose = tests::random_pose(source, 1);
      pose.translation() = place;
      compound.add({tests::random_small_shape(source, i), pose});
    }
  }
  for (std::uint32_t part = 0; part < static_cast<std::uint32_t>(count); part += 7)
    compound.remove(part);
  return compound;
}

TEST(CompoundPairs, TheNearestPartsAreThoseOfAllAskedAlone) {
  RandomSource source(83);
  int apart = 0;
  for (int round = 0; round < 12; ++round) {
    const bool is_on_lattice = round % 2 == 1;
    const Compound a = random_parts(source, 300, is_on_lattice);
    const Compound b = random_parts(source, 240, is_on_lattice);
    Pose pose_a = tests::random_pose(source, 1), pose_b = tests::random_pose(source, 1);
    if (round % 4 == 1) pose_a = tests::at(0), pose_b = tests::at(0);
    const double far = round % 3 == 0 ? 5 : round % 3 == 1 ? 7.5 : 40;
    pose_b.translation() += Eigen::Vector3d(far, 0.25 * round, 0);
    World world, cell, robot;
    const BodyId id_a = world.add({share(a), pose_a}), id_b = world.add({share(b), pose_b});
    cell.add({share(a), pose_a}), robot.add({share(b), pose_b});
    const Nearest wanted = nearest_of_all(a, pose_a, b, pose_b);
    const auto found = world.find_closest_pair();
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(*found, (BodyPairDistance{id_a, id_b, wanted.distance, wanted.part_a, wanted.part_b}))
        << round;
    const auto between = cell.find_closest(PlacedWorldView{robot});
    ASSERT_TRUE(between.has_value());
    EXPECT_EQ(between->distance, wanted.distance) << round;
    EXPECT_EQ(between->part_a, wanted.part_a) << round;
    EXPECT_EQ(between->part_b, wanted.part_b) << round;
    const double least = wanted.distance.distance;
    EXPECT_EQ(cell.find_within({robot}, least).size(), 1u) << round;
    if (least == 0) continue;
    EXPECT_TRUE(cell.find_within({robot}, least * (1 - 0x1p-50)).empty()) << round;
    ++apart;
  }
  EXPECT_GT(apart, 6);
}

/// How many gaps are measured, which is not above the limit.
void expect_few(const Compound& a, const Compound& b, const Pose& pose_b, double limit) {
  Pose slant = Pose::Identity();  // the box of each holds the other
  slant.linear() = Eigen::AngleAxisd(0.9, Eigen::Vector3d(2, 1, 2) / 3).toRotationMatrix();
  World world;
  world.add({share(a), slant}), world.add({share(b), slant * pose_b});
  Work work;
  std::optional<BodyPairDistance> found;
  {
    const ShapeWorkScope scope(work);
    found = world.find_closest_pair();
  }
  ASSERT_TRUE(found && found->distance.distance > 1);
  EXPECT_GT(work.convex_tests, 10u);
  EXPECT_LE(static_cast<double>(work.convex_tests), limit);
}

TEST(CompoundPairs, FewAreMeasuredOfManyThatLieAlongEachOther) {
  Compound tiles, studs;
  for (int x = 0; x < 64; ++x) {
    for (int y = 0; y < 64; ++y) {
      tiles.add({Box{{0.2, 0.2, 0.1}}, tests::at(0.5 * x - 16, 0.5 * y - 16, 0)});
      studs.add({Sphere{{0, 0, 0}, 0.1 + 0.001 * ((x * y) % 50)},
                 tests::at(0.5 * x - 16, 0.5 * y - 16, 0)});
    }
  }
  Pose over = Pose::Identity();
  over.linear() = Eigen::AngleAxisd(0.01, Eigen::Vector3d(0.6, 0.8, 0)).toRotationMatrix();
  over.translation() = Eigen::Vector3d(0.03, 0.02, 2);
  const double pairs = 4096.0 * 4096.0;
  expect_few(tiles, studs, over, pairs / 200);
  expect_few(studs, tiles, over, pairs / 200);
  expect_few(studs, studs, over, pairs / 200);
}

}  // namespace
}  // namespace graze
