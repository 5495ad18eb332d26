// Lists of an update are read while bodies come, move and go: what the loop of README.md does.

#include <graze/engine/world/broad_phase.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using tests::at;

/// What an update listed, copied at once.
struct Copied {
  explicit Copied(const WorldUpdate& update)
      : begun(update.begun.begin(), update.begun.end()),
        ended(update.ended.begin(), update.ended.end()),
        moved(update.moved.begin(), update.moved.end()),
        contacts(update.contacts.begin(), update.contacts.end()) {}
  bool operator==(const Copied&) const = default;

  std::vector<BodyPair> begun, ended, moved;
  std::vector<BodyContact> contacts;
};

TEST(HeldLists, OfAWorldStandUntilItsNextUpdate) {
  RandomSource source(7);
  World world;
  std::vector<BodyId> ids;
  for (int i = 0; i < 40; ++i)
    ids.push_back(
        world.add({Box{{0.5, 0.5, 0.5}}, at({source.uniform(0, 4), source.uniform(0, 4), 0})}));
  std::size_t listed = 0;
  for (int frame = 0; frame < 30; ++frame) {
    const WorldUpdate update = world.update();
    const Copied before(update);
    listed += before.contacts.size() + before.ended.size();
    for (const BodyContact& contact : update.contacts) {
      if (world.contains(contact.pair.a))
        world.move(contact.pair.a, at({source.uniform(0, 4), source.uniform(0, 4), 0}));
    }
    for (int i = 0; i < 5; ++i) {
      const auto which = static_cast<std::size_t>(source.integer(0, 39));
      world.remove(ids[which]);
      ids[which] =
          world.add({Box{{0.5, 0.5, 0.5}}, at({source.uniform(0, 4), source.uniform(0, 4), 0})});
      world.set_shape(ids[(which + 1) % ids.size()], Sphere{{0, 0, 0}, 0.5});
      world.sleep(ids[(which + 2) % ids.size()]);
    }
    world.find_touching({Sphere{{0, 0, 0}, 1}, at(2, 2)});
    world.cast_ray({{2, 2, 5}, {0, 0, -1}});
    EXPECT_EQ(Copied(update), before) << frame;
  }
  EXPECT_GT(listed, 100u);
}

TEST(HeldLists, OfABroadPhaseStandUntilItsNextUpdate) {
  RandomSource source(8);
  BroadPhase broad;
  const auto random_box = [&] {
    const Eigen::Vector3d corner = source.vector(0, 4);
    return Aabb{corner, corner + Eigen::Vector3d(1, 1, 1)};
  };
  std::vector<BoxId> ids;
  for (int i = 0; i < 200; ++i)
    ids.push_back(broad.add(random_box()));
  for (int frame = 0; frame < 30; ++frame) {
    broad.update();
    const std::span<const BoxPair> lists[] = {broad.pairs(), broad.sorted_pairs(), broad.begun(),
                                              broad.ended()};
    std::vector<std::vector<BoxPair>> before;
    for (const std::span<const BoxPair> list : lists)
      before.emplace_back(list.begin(), list.end());
    ASSERT_FALSE(before[0].empty());
    for (int i = 0; i < 20; ++i) {
      const auto which = static_cast<std::size_t>(source.integer(0, 199));
      broad.move(ids[(which + 1) % ids.size()], random_box());
      broad.remove(ids[which]);
      ids[which] = broad.add(random_box());
      std::vector<std::uint32_t> found;
      broad.find_overlapping(random_box(), found);
    }
    for (std::size_t i = 0; i < before.size(); ++i)
      EXPECT_EQ(std::vector<BoxPair>(lists[i].begin(), lists[i].end()), before[i]) << i;
  }
}

}  // namespace
}  // namespace graze
