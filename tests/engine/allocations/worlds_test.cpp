// Random histories of two worlds that are told the same, in one of which allocations fail. A call
// that throws has not happened; an update that throws is made up for by the next one: both then say
// the same, so that no pair is lost, and none is told twice.

#include <graze/engine/world/compound.h>
#include <graze/engine/world/height_field.h>
#include <graze/engine/world/voxel_map.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/engine/allocations/failing_new.h"
#include "tests/engine/first_touch/digest.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_source.h"

namespace graze::tests {
namespace {

class TwinWorlds {
 public:
  TwinWorlds(std::uint64_t seed, const WorldSettings& settings, int most)
      : source_(seed), most_(most), failing_(settings), twin_(settings) {}

  long calls() const { return calls_; }
  long failures() const { return failures_; }
  void fail_at(long n, long again) { due_ = n, again_ = again; }

  void step(int changes) {
    for (int i = 0; i < changes && !testing::Test::HasFailure(); ++i)
      change();
    update();
    ask();
  }

 private:
  template <typename Task>
  void on_trial(const Task& task) {
    constexpr int kMostInTurn = 3;  // or what needs several would never end
    for (int turn = 0;; ++turn) {
      bool has_ended = false;
      {
        const bool may_fail = due_ > calls_ && turn < kMostInTurn;
        const FailingNew armed(may_fail ? due_ - calls_ : FailingNew::kNever);
        try {
          task();
          has_ended = true;
        } catch (const std::bad_alloc&) {
          ++failures_;
        }
        calls_ += armed.calls();
      }
      if (due_ != 0 && calls_ >= due_) due_ = again_ == 0 ? 0 : calls_ + again_;
      if (has_ended) return;
      expect_same_bodies();
    }
  }

  void expect_same_bodies() {
    ASSERT_EQ(failing_.size(), twin_.size());
    for (const BodyId id : ids_) {
      ASSERT_TRUE(failing_.contains(id));
      ASSERT_TRUE(failing_.pose(id).matrix() == twin_.pose(id).matrix());
      ASSERT_EQ(&failing_.shape(id), &twin_.shape(id));
      ASSERT_EQ(failing_.filter(id).group, twin_.filter(id).group);
      ASSERT_EQ(failing_.is_awake(id), twin_.is_awake(id));
    }
  }

  Pose place() {
    return at({source_.integer(0, 5) * 0.75, source_.integer(0, most_ / 8) * 0.75, 0});
  }

  /// One for all: each thread keeps some patches of fields that it has met.
  static std::shared_ptr<const BodyShape> field() {
    static const std::vector<float> heights = {0, 0.25F, 0, 0.5F, 0.25F, 0.5F, 0, 0, 0.25F};
    static const std::shared_ptr<const BodyShape> shared = share(Shape(HeightField(
        3, 3, std::span<const float>(heights), {.spacing_x = 0.25, .spacing_y = 0.25})));
    return shared;
  }

  std::shared_ptr<const BodyShape> shape() {
    static const Mesh box = make_box({0.5, 0.5, 0.5}), ball = make_sphere(0.5, 3, 4);
    const auto kind = source_.integer(0, 7);
    if (kind == 0) return share(Shape(Sphere{{0, 0, 0}, 0.5}));
    if (kind == 1) return share(Shape(Box{{0.5, 0.5, 0.5}}));
    if (kind == 2) return share(Shape(Capsule{0.25, 0.25}));
    if (kind == 5) {
      Compound two;
      two.add({Sphere{{0, 0, 0}, 0.25}, at(0.25)});
      two.add({box, at(-0.25, 0.125)});
      return share(two);
    }
    if (kind == 6) return field();
    if (kind == 7) {
      VoxelMap map({{-0.5, -0.5, -0.5}, 0.25, {4, 4, 4}});
      map.add_block({0, 0, 0}, {3, 3, 1});
      map.add(std::vector<Voxel>{{1, 2, 3}});
      return share(map);
    }
    const Mesh& mesh = kind == 3 ? box : ball;
    return share(Shape(Mesh(mesh.vertices(), mesh.triangles())));
  }

  /// Both are told the same.
  template <typename Task>
  void both(const Task& task) {
    on_trial([&] { task(failing_); });
    task(twin_);
  }

  void add() {
    const auto body = shape();
    const Pose pose = place();
    BodyId id;
    on_trial([&] { id = failing_.add({body, pose}); });
    ASSERT_EQ(twin_.add({body, pose}), id);
    ids_.push_back(id);
  }

  void change() {
    const auto count = static_cast<int>(ids_.size());
    const double die = source_.uniform(0, 1);
    if (count < most_ / 2 || (die < 0.15 && count < most_)) return add();
    const auto i = static_cast<std::size_t>(source_.integer(0, count - 1));
    const BodyId id = ids_[i];
    const BodyId other = ids_[(i + 1) % ids_.size()];
    if (die < 0.25) {
      both([&](World& world) { world.remove(id); });
      ids_.erase(ids_.begin() + static_cast<std::ptrdiff_t>(i));
    } else if (die < 0.4) {
      const auto instead = shape();
      both([&](World& world) { world.set_shape(id, instead); });
    } else if (die < 0.6) {
      const Pose pose = place();
      both([&](World& world) { world.move(id, pose); });
    } else if (die < 0.65) {
      const RigidMotion motion = RigidMotion::between(twin_.pose(id), place());
      both([&](World& world) { world.set_detection(id, Detection::Continuous); });
      both([&](World& world) { world.move(id, motion); });
    } else if (die < 0.72) {
      std::vector<Pose> poses;
      for (std::size_t k = 0; k < ids_.size(); ++k)
        poses.push_back(place());
      both([&](World& world) { world.move(ids_, poses); });
    } else if (die < 0.78) {
      both([&](World& world) { world.set_filter(id, {.group = -static_cast<int>(i % 2)}); });
    } else if (die < 0.82) {
      both([&](World& world) { world.set_role(id, i % 2 == 0 ? Role::Sensor : Role::Solid); });
    } else if (die < 0.86) {
      both([&](World& world) { world.set_margin(id, i % 2 == 0 ? 0.25 : 0); });
    } else if (die < 0.9) {
      both([&](World& world) { world.exclude(id, other); });
    } else if (die < 0.95) {
      both([&](World& world) { world.include(id, other); });
    } else if (die < 0.97) {
      both([&](World& world) { world.sleep(id); });
      both([&](World& world) { world.wake(id); });
    } else {
      both([&](World& world) {
        world.set_pair_filter([](BodyId a, BodyId b) { return (a.index + b.index) % 7 != 3; });
      });
    }
  }

  static Digest told(std::span<const BodyPair> pairs) {
    Digest digest;
    for (const BodyPair& pair : pairs)
      digest << pair.a.index << pair.a.generation << pair.b.index << pair.b.generation;
    return digest;
  }

  static Digest told(std::span<const BodyFirstContact> contacts) {
    Digest digest;
    for (const BodyFirstContact& contact : contacts)
      digest << contact.pair.a.index << contact.pair.b.index << contact.contact.low;
    return digest;
  }

  void update() {
    const long failures = failures_;
    on_trial([&] {
      const WorldUpdate update = failing_.update();
      // What it says is copied without a failure: it was told.
      begun_.assign(update.begun.begin(), update.begun.end());
      ended_.assign(update.ended.begin(), update.ended.end());
      begun_near_.assign(update.begun_near.begin(), update.begun_near.end());
      ended_near_.assign(update.ended_near.begin(), update.ended_near.end());
      first_contacts_.assign(update.first_contacts.begin(), update.first_contacts.end());
    });
    const WorldUpdate update = twin_.update();
    ASSERT_TRUE(told(begun_) == told(update.begun)) << "begun, after " << failures_ - failures;
    ASSERT_TRUE(told(ended_) == told(update.ended)) << "ended, after " << failures_ - failures;
    ASSERT_TRUE(told(begun_near_) == told(update.begun_near)) << "begun to be near";
    ASSERT_TRUE(told(ended_near_) == told(update.ended_near)) << "ended to be near";
    ASSERT_TRUE(told(first_contacts_) == told(update.first_contacts));
    ASSERT_EQ(failing_.pairs(), twin_.pairs());
    if (source_.uniform(0, 1) < 0.4) {
      on_trial([&] {
        const WorldSnapshot kept = failing_.snapshot();
        failing_.restore(kept);
      });
      twin_.restore(twin_.snapshot());
    }
  }

  Digest asked(const World& world) {
    Digest digest;
    for (const BodyContact& contact : world.contacts()) {
      digest << contact.pair.a.index << contact.pair.b.index;
      for (const ShapeContact& point : contact.manifold)
        digest << point.depth << point.normal << point.point;
    }
    for (const BodyId id : world.find_in_box({{0, 0, -1}, {2, 2, 1}}))
      digest << id.index;
    for (const BodyId id : world.find_touching({Sphere{{0, 0, 0}, 1}, at(1, 0.5)}))
      digest << id.index;
    for (const BodyRayHit& hit : world.cast_ray_all(Ray{{-5, 0.1, 0.1}, {1, 0.01, 0}}))
      digest << hit.id.index << hit.hit.distance;
    if (const auto closest = world.find_closest({Box{{0.1, 0.1, 0.1}}, at(4, 20)}))
      digest << closest->id.index << closest->distance.distance;
    for (const BodyDistance& near : world.find_within({Sphere{{0, 0, 0}, 1}, at(1, 0.5)}, 0.2))
      digest << near.id.index << near.distance.distance;
    const RigidMotion across = RigidMotion::between(at(0, 0.125, 0.25), at(1, 0.5, 0.25));
    for (const BodyCast& met : world.cast_all({Sphere{{0, 0, 0}, 0.125}, across}))
      digest << met.id.index << met.contact.low;
    for (const std::vector<BodyId>& island : world.islands()) {
      for (const BodyId id : island)
        digest << id.index;
      digest << world.touching(island.front()).size();
    }
    return digest;
  }

  void ask() {
    Digest answer;
    on_trial([&] { answer = asked(failing_); });
    ASSERT_TRUE(answer == asked(twin_));
  }

  RandomSource source_;
  int most_;
  World failing_, twin_;
  std::vector<BodyId> ids_;
  std::vector<BodyPair> begun_ = std::vector<BodyPair>(1000), ended_ = begun_, begun_near_ = begun_,
                        ended_near_ = begun_;
  std::vector<BodyFirstContact> first_contacts_ = std::vector<BodyFirstContact>(1000);
  long calls_ = 0, due_ = 0, again_ = 0, failures_ = 0;
};

struct WorldHistory {
  std::uint64_t seed;
  int most;  // bodies
  int threads = 1;
};

WorldSettings settings_of(const WorldHistory& history) {
  return {.threads = history.threads,
          .islands = true,
          .skip_apart = history.seed % 3 != 0,
          .skip_at_rest = history.seed % 5 != 4};
}

long play_worlds(const WorldHistory& history, long n, long again, long& failures) {
  TwinWorlds worlds(history.seed, settings_of(history), history.most);
  worlds.fail_at(n, again);
  for (int step = 0; step < 7 && !testing::Test::HasFailure(); ++step)
    worlds.step(step == 0 ? history.most : 1 + history.most / 6);
  failures += worlds.failures();
  return worlds.calls();
}

void fail_allocations_of_worlds(const WorldHistory& history, long most) {
  // Which of many threads that build trees come to have memory of their own is chance.
  const int threads = std::max(history.threads, 2);
  const tbb::global_control few(tbb::global_control::max_allowed_parallelism,
                                static_cast<std::size_t>(threads));
  long none = 0, failures = 0;
  const long count = play_worlds(history, 0, 0, none);
  EXPECT_EQ(none, 0);
  EXPECT_GT(count, 200);
  for (long n = 1; n <= count; n = next_failure(n, count, most)) {
    SCOPED_TRACE("allocation " + std::to_string(n) + ", seed " + std::to_string(history.seed));
    const long before = live_blocks();
    play_worlds(history, n, n % 3 == 0 ? 1 + n % 11 : 0, failures);
    // Other threads have memory of their own, which they keep.
    if (history.threads == 1) {
      EXPECT_EQ(live_blocks(), before);
    }
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(failures, 10);
}

TEST(Allocations, OfWorldsMayFail) {
  for (std::uint64_t seed = 0; seed < 4; ++seed)
    fail_allocations_of_worlds({seed, 8}, 40);
}

TEST(Allocations, OfWorldsThatThreadsShareMayFail) {
  for (std::uint64_t seed = 0; seed < 3; ++seed)
    fail_allocations_of_worlds({.seed = seed, .most = 40, .threads = 3}, 24);
}

/// Planks that lie on two blocks each: eight contacts, for which a manifold needs memory.
Mesh make_blocks() {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  const Mesh block = make_box({0.25, 0.5, 0.5});
  for (const double x : {-1.0, 1.0}) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const Eigen::Vector3d& vertex : block.vertices())
      vertices.push_back(vertex + Eigen::Vector3d(x, 0, 0));
    for (const TriangleIndices& triangle : block.triangles())
      triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
  }
  return Mesh(vertices, triangles);
}

/// Every pair begins once, whichever allocation of the first update fails.
TEST(Allocations, OfManifoldsThatThreadsShareMayFail) {
  const tbb::global_control few(tbb::global_control::max_allowed_parallelism, 2);
  const auto blocks = share(Shape(make_blocks()));
  const auto plank = share(Shape(make_box({1.5, 0.5, 0.0625})));
  const auto begun_in_all = [&](long n, long* count) {
    World world({.threads = 2, .islands = true});
    for (int i = 0; i < 40; ++i) {
      world.add({blocks, at(4.0 * i)}, {.kind = BodyKind::Static});
      world.add({plank, at(4.0 * i, 0.125, 0.5)});
    }
    std::size_t begun = 0, contacts = 0;
    const auto update = [&] {
      const WorldUpdate told = world.update();
      begun += told.begun.size();
      if (!told.contacts.empty()) contacts = told.contacts[0].manifold.size();
    };
    {
      const FailingNew armed(n);
      try {
        update();
      } catch (const std::bad_alloc&) {
        begun = 0;  // nothing was told
      }
      if (count != nullptr) *count = armed.calls();
    }
    update();
    EXPECT_EQ(world.pairs().size(), 40U);
    EXPECT_EQ(world.islands().size(), 40U);
    if (n == FailingNew::kNever) {
      EXPECT_GT(contacts, Manifold::kMostOfRegion);
    }
    return begun;
  };
  long count = 0;
  begun_in_all(FailingNew::kNever, nullptr);  // builds trees
  ASSERT_EQ(begun_in_all(FailingNew::kNever, &count), 40U);
  for (long n = 1; n <= count && !HasFailure(); ++n)
    EXPECT_EQ(begun_in_all(n, nullptr), 40U) << "allocation " << n << " of " << count;
}

TEST(AllocationsSlow, OfWorldsMayFail) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    fail_allocations_of_worlds({seed, 10}, 1000000);
    fail_allocations_of_worlds({seed, 60}, 200);
    fail_allocations_of_worlds({.seed = seed, .most = 60, .threads = 3}, 100);
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace
}  // namespace graze::tests
