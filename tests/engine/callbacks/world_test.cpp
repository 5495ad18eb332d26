// Whatever a world asks of its user - shapes, filters - may throw, at any call and several times in
// a row. What was asked for has then not happened; an update is made up for by the next one that
// comes to its end: no pair is lost, and none is told twice.

#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/engine/callbacks/fuse.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_source.h"

namespace graze::tests {
namespace {

using Pairs = std::vector<BodyPair>;

/// A world whose shapes and filter have a fuse, beside what it must say: the bodies by hand, each
/// asked about each, by shapes without a fuse.
class FusedWorld {
 public:
  FusedWorld(std::uint64_t seed, const WorldSettings& settings) : source_(seed), world_(settings) {
    filter();
  }

  Fuse& fuse() { return *fuse_; }
  World& world() { return world_; }
  const World& world() const { return world_; }
  long updates_cut() const { return updates_cut_; }
  long calls_cut() const { return calls_cut_; }

  /// Some changes at random. What throws has changed nothing, and is done again.
  void change(int count) {
    for (int i = 0; i < count; ++i)
      change_something();
  }

  /// An update; false if it was cut short. What it says is compared with what must be.
  bool update() {
    WorldUpdate update;
    try {
      update = world_.update();
    } catch (const Burnt&) {
      ++updates_cut_;
      EXPECT_THROW(world_.contacts(), InputError);
      EXPECT_THROW(world_.snapshot(), InputError);
      return false;
    }
    const Pairs now = pairs_now();
    EXPECT_EQ(Pairs(update.begun.begin(), update.begun.end()), difference(now, before_));
    EXPECT_EQ(Pairs(update.ended.begin(), update.ended.end()), difference(before_, now));
    EXPECT_TRUE(std::is_sorted(update.moved.begin(), update.moved.end()));
    EXPECT_EQ(std::adjacent_find(update.moved.begin(), update.moved.end()), update.moved.end());
    EXPECT_TRUE(std::includes(now.begin(), now.end(), update.moved.begin(), update.moved.end()));
    for (const BodyPair& pair : difference(now, before_))
      EXPECT_TRUE(std::binary_search(update.moved.begin(), update.moved.end(), pair));
    EXPECT_EQ(update.contacts.size(), update.moved.size());
    EXPECT_EQ(world_.pairs(), now);
    before_ = now;
    return true;
  }

  /// The world and the bodies by hand are the same ones.
  void expect_bodies_as_by_hand() const {
    ASSERT_EQ(world_.size(), bodies_.size());
    for (const auto& [id, body] : bodies_) {
      ASSERT_TRUE(world_.contains(id));
      EXPECT_EQ(world_.pose(id).data()[12], body.pose.data()[12]);
      EXPECT_EQ(world_.pose(id).data()[13], body.pose.data()[13]);
      EXPECT_EQ(&world_.shape(id), body.fused.get());
      EXPECT_EQ(world_.find_in_box(body.bare->bounds(body.pose)).empty(), false);
    }
  }

 private:
  struct ByHand {
    std::shared_ptr<const BodyShape> fused, bare;
    Pose pose;
  };

  /// Moves stay on a small lattice, so that pairs begin and end at almost every step.
  Pose random_place() {
    return at({source_.integer(0, 5) * 0.75, source_.integer(0, 1) * 0.75, 0});
  }

  ByHand random_body() {
    static const Mesh mesh = make_box({0.5, 0.5, 0.5});
    ByHand body;
    const int kind = static_cast<int>(source_.integer(0, 3));
    // Each mesh is one of its own, so that its tree is counted by the world.
    const Shape shape = kind == 0   ? Shape(Sphere{{0, 0, 0}, 0.5})
                        : kind == 1 ? Shape(Box{{0.5, 0.5, 0.5}})
                                    : Shape(Mesh(mesh.vertices(), mesh.triangles()));
    body.bare = share(shape);
    const auto look = kind == 3 ? FusedShape::Look::Transparent : FusedShape::Look::Opaque;
    body.fused = std::make_shared<FusedShape>(shape, fuse_, look);
    body.pose = random_place();
    return body;
  }

  void filter() {
    const auto none_of_a_group = [fuse = fuse_](BodyId a, BodyId b) {
      fuse->burn();
      return (a.index + b.index) % 7 != 3;
    };
    world_.set_pair_filter(none_of_a_group);
  }

  void change_something() {
    const ByHand other = random_body();
    const double die = source_.uniform(0, 1);
    if (bodies_.size() < 4 || (die < 0.15 && bodies_.size() < 9)) {
      attempt([&] { bodies_[world_.add({other.fused, other.pose})] = other; });
      return;
    }
    auto chosen = bodies_.begin();
    std::advance(chosen,
                 static_cast<int>(source_.integer(0, static_cast<int>(bodies_.size()) - 1)));
    const BodyId id = chosen->first;
    if (die < 0.25) {
      attempt([&] { world_.remove(id), bodies_.erase(id); });
    } else if (die < 0.4) {
      attempt([&] {
        world_.set_shape(id, other.fused);
        bodies_[id].fused = other.fused, bodies_[id].bare = other.bare;
      });
    } else if (die < 0.75) {
      attempt([&] { world_.move(id, other.pose), bodies_[id].pose = other.pose; });
    } else if (die < 0.95) {
      move_all();
    } else {
      attempt([&] { restore(); });
    }
  }

  void move_all() {
    std::vector<BodyId> ids;
    std::vector<Pose> poses;
    for (const auto& [id, body] : bodies_)
      ids.push_back(id), poses.push_back(random_place());
    attempt([&] {
      world_.move(ids, poses);
      for (std::size_t i = 0; i < ids.size(); ++i)
        bodies_[ids[i]].pose = poses[i];
    });
  }

  /// Where changes wait for an update there is no snapshot, and nothing is asked.
  void restore() {
    std::optional<WorldSnapshot> snapshot;
    try {
      snapshot = world_.snapshot();
    } catch (const InputError&) {
      return;
    }
    world_.restore(*snapshot);
  }

  void attempt(const std::function<void()>& change) {
    try {
      change();
      return;
    } catch (const Burnt&) {
      ++calls_cut_;
    }
    expect_bodies_as_by_hand();
    change();  // the fuse has burnt
  }

  Pairs pairs_now() const {
    Pairs pairs;
    for (auto a = bodies_.begin(); a != bodies_.end(); ++a) {
      for (auto b = std::next(a); b != bodies_.end(); ++b) {
        if ((a->first.index + b->first.index) % 7 == 3) continue;
        if (a->second.bare->touches(a->second.pose, *b->second.bare, b->second.pose))
          pairs.push_back({a->first, b->first});
      }
    }
    return pairs;
  }

  static Pairs difference(const Pairs& s, const Pairs& t) {
    Pairs left;
    std::set_difference(s.begin(), s.end(), t.begin(), t.end(), std::back_inserter(left));
    return left;
  }

  RandomSource source_;
  std::shared_ptr<Fuse> fuse_ = std::make_shared<Fuse>();
  World world_;
  std::map<BodyId, ByHand> bodies_;  // in the order of ids, as lists are
  Pairs before_;                     // what touched at the last update that came to its end
  long updates_cut_ = 0, calls_cut_ = 0;
};

WorldSettings settings_of(int round) {
  return {.threads = round % 2 == 0 ? 1 : 3,
          .skip_apart = round % 3 != 0,
          .skip_at_rest = round % 5 != 0,
          .skip_unused_trees = round % 4 != 0};
}

/// One history, thrown at in its n-th call. How many calls it has in all.
long play(int round, long n, long& cut) {
  FusedWorld world(static_cast<std::uint64_t>(round), settings_of(round));
  if (n > 0) world.fuse().light(n);
  for (int step = 0; step < 8; ++step) {
    world.change(step == 0 ? 8 : 3);
    while (!world.update())
      world.expect_bodies_as_by_hand();
  }
  cut += world.updates_cut() + world.calls_cut();
  EXPECT_EQ(world.updates_cut() + world.calls_cut(), n > 0) << n;
  return world.fuse().calls();
}

void throw_at_every_call(int rounds) {
  const long living = FusedShape::living();
  for (int round = 0; round < rounds; ++round) {
    long none = 0, cut = 0;
    const long calls = play(round, 0, none);
    for (long n = 1; n <= calls; ++n) {
      SCOPED_TRACE("history " + std::to_string(round) + ", call " + std::to_string(n));
      play(round, n, cut);
      if (testing::Test::HasFailure()) return;
    }
    EXPECT_EQ(cut, calls);
    EXPECT_EQ(FusedShape::living(), living);
  }
}

TEST(WorldCallbacks, MayThrowAtEveryCall) {
  throw_at_every_call(2);
}

TEST(WorldCallbacksSlow, MayThrowAtEveryCall) {
  throw_at_every_call(60);
}

/// Updates are cut short several times in a row, with changes between them.
void throw_again_and_again(int seeds) {
  const long living = FusedShape::living();
  long cut = 0, complete = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    SCOPED_TRACE("history " + std::to_string(seed));
    RandomSource source(static_cast<std::uint64_t>(seed) + 1000);
    FusedWorld world(static_cast<std::uint64_t>(seed), settings_of(seed));
    for (int step = 0; step < 40; ++step) {
      world.fuse().douse();
      world.change(step == 0 ? 8 : 3);
      if (source.uniform(0, 1) < 0.7) world.fuse().light(static_cast<long>(source.integer(1, 60)));
      (world.update() ? complete : cut) += 1;
      if (testing::Test::HasFailure()) return;
    }
    world.fuse().douse();
    EXPECT_TRUE(world.update());
    world.expect_bodies_as_by_hand();
  }
  EXPECT_GT(cut, 4 * seeds);
  EXPECT_GT(complete, 5 * seeds);
  EXPECT_EQ(FusedShape::living(), living);
}

TEST(WorldCallbacks, MayThrowAgainAndAgain) {
  throw_again_and_again(60);
}

TEST(WorldCallbacksSlow, MayThrowAgainAndAgain) {
  throw_again_and_again(10000);
}

/// A pair that began, ended and began again while updates were cut short has begun, once.
TEST(WorldCallbacks, APairThatCameAndWentWhileUpdatesWereCutShortIsToldOnce) {
  for (const bool do_touch_first : {false, true}) {
    World world;
    const auto fuse = std::make_shared<Fuse>();
    const BodyId still = world.add({Sphere{{0, 0, 0}, 1}, at(0)});
    const BodyId comes = world.add({Sphere{{0, 0, 0}, 1}, at(do_touch_first ? 1 : 5)});
    // These two are asked about last, and throw.
    const auto last =
        std::make_shared<FusedShape>(Shape(Sphere{{0, 0, 0}, 1}), fuse, FusedShape::Look::Opaque);
    world.add({last, at(20)});
    const BodyId other = world.add({last, at(21)});
    world.update();
    bool does_touch = do_touch_first;
    for (int i = 0; i < 3; ++i) {
      does_touch = !does_touch;
      world.move(comes, at(does_touch ? 1 : 5));
      world.move(other, at(i % 2 == 0 ? 21.5 : 21));
      if (i == 2) break;
      fuse->light(1);
      EXPECT_THROW(world.update(), Burnt);
    }
    const WorldUpdate update = world.update();
    const Pairs pair{{still, comes}};
    EXPECT_EQ(Pairs(update.begun.begin(), update.begun.end()), does_touch ? pair : Pairs());
    EXPECT_EQ(Pairs(update.ended.begin(), update.ended.end()), does_touch ? Pairs() : pair);
  }
}

}  // namespace
}  // namespace graze::tests
