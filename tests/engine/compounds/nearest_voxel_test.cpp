// Questions about maps of voxels beside each voxel asked alone: from far away, of equal distances,
// and of maps that lie far from their frame's origin; and how many voxels that takes.

#include <graze/engine/work.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/shape_ray.h>
#include <graze/engine/world/shapes/shape_work.h>
#include <graze/engine/world/voxel_map.h>
#include <graze/engine/world/world.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "tests/engine/motion/moving_bodies.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

/// What each voxel says as a box of its own.
class EachVoxel {
 public:
  EachVoxel(const VoxelMap& map, const Pose& pose) {
    for (const Voxel& voxel : map.voxels())
      numbers_.push_back(map.part(voxel));
    std::sort(numbers_.begin(), numbers_.end());
    for (const std::uint32_t number : numbers_)
      boxes_.push_back({map.box(), placed_part(pose, map.pose(number))});
  }

  struct Nearest {
    ShapeDistance distance;
    std::uint32_t part;
    bool operator==(const Nearest&) const = default;
  };
  Nearest nearest(const PlacedShapeView& shape) const {
    std::optional<Nearest> best;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const ShapeDistance found = distance(shape, boxes_[i]);
      if (!best || found.distance < best->distance.distance) best = {found, numbers_[i]};
    }
    return *best;
  }
  bool is_touched(const PlacedShapeView& shape) const {
    return std::any_of(boxes_.begin(), boxes_.end(),
                       [&](const PlacedShape& box) { return intersects(shape, box); });
  }
  std::optional<RayHit> cast_ray(const Ray& ray) const {
    std::optional<RayHit> first;
    for (const PlacedShape& box : boxes_) {
      const auto hit = graze::cast_ray(box, ray);
      if (hit && (!first || hit->distance < first->distance)) first = hit;
    }
    return first;
  }

 private:
  std::vector<std::uint32_t> numbers_;
  std::vector<PlacedShape> boxes_;
};

VoxelMap random_map(RandomSource& source, const VoxelGrid& grid) {
  VoxelMap map(grid);
  const auto at = [&](int k) {
    return static_cast<std::uint16_t>(source.integer(0, static_cast<int>(grid.counts[k]) - 1));
  };
  for (int i = 0; i < 200; ++i) {
    const Voxel voxel{at(0), at(1), at(2)};
    map.add(std::vector{voxel});
  }
  // A floor, above which many are as near as each other.
  const auto last = [&](int k) { return static_cast<std::uint16_t>(grid.counts[k] / 2); };
  map.add_block({0, 0, 0}, {last(0), last(1), 0});
  return map;
}

/// Once as one body; answers that were compared.
std::size_t ask(const VoxelMap& map, const Pose& pose, RandomSource& source) {
  const VoxelGrid& grid = map.grid();
  const Eigen::Vector3d own = Eigen::Vector3d(grid.plane(0, grid.counts[0] / 2),
                                              grid.plane(1, grid.counts[1] / 2), grid.plane(2, 3));
  const Eigen::Vector3d middle = pose * own;
  World world;
  world.add({share(map), pose}, {.kind = BodyKind::Static});
  const EachVoxel each(map, pose);
  std::size_t answers = 0;
  for (int i = 0; i < 12; ++i) {
    const Shape shape = tests::random_small_shape(source, i);
    for (const double far : {0.7, 3.0, 300.0}) {
      Pose at = tests::random_pose(source, far * grid.edge * 20);
      if (i % 2 == 0) at.linear() = pose.linear();
      at.translation() += middle;
      const auto found = world.find_closest({shape, at});
      const EachVoxel::Nearest wanted = each.nearest({shape, at});
      EXPECT_TRUE((EachVoxel::Nearest{found->distance, found->part} == wanted))
          << found->distance.distance << " " << found->part << " and " << wanted.distance.distance
          << " " << wanted.part;
      const double clearance = wanted.distance.distance;
      EXPECT_EQ(world.find_within({shape, at}, clearance).size(), 1u);
      EXPECT_EQ(world.find_within({shape, at}, clearance * (1 - 0x1p-50)).size(),
                clearance > 0 ? 0u : 1u);
      World other;
      other.add({shape, at});
      const auto pair = other.find_closest(PlacedWorldView{world});
      EXPECT_EQ(pair->part_b, wanted.part);
      EXPECT_EQ(pair->distance.distance, clearance);
      const auto mirrored = world.find_closest(PlacedWorldView{other});
      EXPECT_EQ(mirrored->part_a, wanted.part);
      EXPECT_EQ(mirrored->distance.distance, clearance);
      const bool is_hit = each.is_touched({shape, at});
      EXPECT_EQ(world.find_touching({shape, at}).size(), is_hit ? 1u : 0u);
      const Ray ray{at.translation(), middle + source.vector(-1, 1) - at.translation()};
      const auto hit = world.cast_ray(ray);
      const auto wanted_hit = each.cast_ray(ray);
      EXPECT_EQ(hit.has_value(), wanted_hit.has_value());
      if (hit && wanted_hit) {
        EXPECT_EQ(hit->hit, *wanted_hit);
      }
      answers += 1 + is_hit + hit.has_value();
    }
  }
  return answers;
}

TEST(NearestVoxel, IsThatOfAllAskedAlone) {
  RandomSource source(91);
  std::size_t answers = 0;
  for (int round = 0; round < 6 && !HasFailure(); ++round) {
    const VoxelGrid grid{{-1, -1, 0}, round % 2 == 0 ? 0.0625 : 0.1, {40, 36, 24}};
    const auto map = random_map(source, grid);
    const Pose pose = round % 3 == 0 ? tests::at(0) : tests::random_pose(source, 5);
    answers += ask(map, pose, source);
  }
  EXPECT_GT(answers, 250u);
}

TEST(NearestVoxel, IsTheSameFarFromTheFramesOrigin) {
  RandomSource source(92);
  for (const double far : {1e3, 5e6, 1e12}) {
    const VoxelGrid grid{{far, -0.1 * far, 0.01 * far}, 0.25, {40, 36, 24}};
    const VoxelMap map = random_map(source, grid);
    ask(map, tests::at(0), source);
    ask(map, tests::at(-far, 0.1 * far, -0.01 * far), source);
    ask(map, tests::random_pose(source, 5), source);
    if (HasFailure()) return;
  }
}

/// How many voxels are measured.
std::uint64_t measured(const World& world, const PlacedShapeView& shape) {
  Work work;
  const ShapeWorkScope scope(work);
  EXPECT_TRUE(world.find_closest(shape).has_value());
  return work.convex_tests;
}

TEST(NearestVoxel, FewAreMeasuredOfManyThatAreFarAway) {
  VoxelMap floor({{-16, -16, 0}, 0.0625, {512, 512, 64}}),
      block({{-4, -4, -4}, 0.125, {64, 64, 64}});
  floor.add_block({0, 0, 0}, {511, 511, 1});
  block.add_block({0, 0, 0}, {63, 63, 63});
  RandomSource source(93);
  for (const VoxelMap& map : {floor, block}) {
    World world;
    const Pose pose = tests::random_pose(source, 5);
    world.add({share(map), pose});
    for (const double far : {0.5, 5.0, 50.0, 500.0}) {
      for (int i = 0; i < 6; ++i) {
        const Eigen::Vector3d away = source.vector(-1, 1).normalized() * (far + 12);
        const Shape ball = Sphere{{0, 0, 0}, 0.25};
        const Eigen::Vector3d at = pose.translation() + away;
        EXPECT_LE(measured(world, {ball, tests::at(at.x(), at.y(), at.z())}), 4000u) << far;
      }
    }
  }
}

}  // namespace
}  // namespace graze
