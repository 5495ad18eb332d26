#include "tests/engine/compounds/pieces.h"

#include <graze/engine/world/compound.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/voxel_map.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "tests/engine/motion/moving_bodies.h"

namespace graze::tests {

std::vector<Piece> pieces_of(const World& world, const Pose& in) {
  std::vector<Piece> pieces;
  for (const BodyId id : world.bodies()) {
    const Pose pose = placed_part(in, world.pose(id));
    const auto add = [&](std::uint32_t part, const Shape& shape, const Pose& of_part,
                         const Filter& filter) {
      pieces.push_back({id, part, shape, of_part, filter, world.role(id), world.kind(id)});
    };
    if (const Compound* compound = compound_of(world.shape(id))) {
      for (const std::uint32_t part : compound->parts()) {
        const PlacedShape& placed = compound->part(part);
        add(part, placed.shape, placed_part(pose, placed.pose),
            compound->settings(part).filter.value_or(world.filter(id)));
      }
    } else if (const VoxelMap* map = voxel_map_of(world.shape(id))) {
      std::vector<std::uint32_t> numbers;
      for (const Voxel& voxel : map->voxels())
        numbers.push_back(map->part(voxel));
      std::sort(numbers.begin(), numbers.end());
      for (const std::uint32_t part : numbers)
        add(part, map->box(), placed_part(pose, map->pose(part)), world.filter(id));
    } else {
      add(0, *world.shape(id).shape(), pose, world.filter(id));
    }
  }
  return pieces;
}

bool are_asked_for(const World& world_a, const Piece& a, const World& world_b, const Piece& b,
                   const WorldPairSettings& settings) {
  if (settings.role && (a.role != *settings.role || b.role != *settings.role)) return false;
  if (!settings.has_filters) return true;
  return lets_pass(world_a.filter(a.body), world_b.filter(b.body)) && lets_pass(a.filter, b.filter);
}

bool is_nearer(const BodyPairDistance& s, const BodyPairDistance& t) {
  const auto key = [](const BodyPairDistance& each) {
    return std::tuple(each.distance.distance, each.a, each.b, each.part_a, each.part_b);
  };
  return key(s) < key(t);
}

Truth truth_of(const World& a, const World& b, const Pose& pose, double clearance,
               const WorldPairSettings& settings) {
  Truth truth;
  const std::vector<Piece> pieces_b = pieces_of(b, pose);
  std::vector<BodyPairDistance> all;
  for (const Piece& s : pieces_of(a, Pose::Identity())) {
    for (const Piece& t : pieces_b) {
      if (!are_asked_for(a, s, b, t, settings)) continue;
      if (intersects({s.shape, s.pose}, {t.shape, t.pose}))
        truth.touching.push_back({s.body, t.body});
      all.push_back(
          {s.body, t.body, distance({s.shape, s.pose}, {t.shape, t.pose}), s.part, t.part});
    }
  }
  std::sort(truth.touching.begin(), truth.touching.end());
  truth.touching.erase(std::unique(truth.touching.begin(), truth.touching.end()),
                       truth.touching.end());
  std::sort(all.begin(), all.end(), is_nearer);
  if (!all.empty()) truth.closest = all[0];
  for (const BodyPairDistance& each : all) {
    const bool is_known = std::any_of(
        truth.within.begin(), truth.within.end(),
        [&](const BodyPairDistance& other) { return other.a == each.a && other.b == each.b; });
    if (!is_known && each.distance.distance <= clearance) truth.within.push_back(each);
  }
  std::sort(truth.within.begin(), truth.within.end(),
            [](const BodyPairDistance& s, const BodyPairDistance& t) {
              return std::tie(s.a, s.b) < std::tie(t.a, t.b);
            });
  return truth;
}

Shape any_shape(RandomSource& source) {
  return random_small_shape(source, static_cast<int>(source.integer(0, 5)));
}

void expect_equal(const std::vector<BodyPairDistance>& found,
                  const std::vector<BodyPairDistance>& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const BodyPairDistance &s = found[i], &t = wanted[i];
    EXPECT_TRUE(s == t) << s.a.index << "/" << s.part_a << " " << s.b.index << "/" << s.part_b
                        << " at " << s.distance.distance << ", not " << t.a.index << "/" << t.part_a
                        << " " << t.b.index << "/" << t.part_b << " at " << t.distance.distance;
  }
}

}  // namespace graze::tests
