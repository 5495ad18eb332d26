// Updates that threads share: what a world says, and what it did, are the same bit for bit however
// many there are. Suites whose names end in Threads run under ThreadSanitizer, where trees are
// built beforehand: oneTBB's own memory, which it cannot follow, is left alone there.

#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/prepare.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

#include "tests/engine/body_world/users_ball.h"
#include "tests/engine/first_touch/digest.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using tests::at;
using tests::Digest;
using tests::UsersBall;

/// All that an update says and did.
Digest told(const World& world, const WorldUpdate& update) {
  Digest digest;
  const auto tell = [&](std::span<const BodyPair> pairs) {
    digest << pairs.size();
    for (const BodyPair& pair : pairs)
      digest << pair.a.index << pair.a.generation << pair.b.index << pair.b.generation;
  };
  tell(update.begun), tell(update.ended), tell(update.moved), tell(world.pairs());
  digest << update.contacts.size();
  for (const auto& [pair, manifold] : update.contacts) {
    digest << pair.a.index << pair.a.generation << pair.b.index << pair.b.generation;
    digest << manifold.size();
    for (const ShapeContact& contact : manifold) {
      digest << contact.point << contact.point_a << contact.point_b << contact.normal;
      digest << contact.depth << contact.feature.a << contact.feature.b;
    }
  }
  return digest;
}

struct PileSettings {
  bool are_trees_built = false;
  bool has_shapes_for_caller = true;  // that other threads may not ask
  int bodies = 400;
  WorldSettings world = {};
};

/// The same pile in several worlds: boxes, balls, hulls and other shapes, meshes, sensors and
/// shapes of a user's own of either kind, poured over a floor of triangles, with filters; some
/// sleep, go, come and change.
class Piles {
 public:
  Piles(const std::vector<int>& threads, const PileSettings& settings) : settings_(settings) {
    for (const int count : threads) {
      WorldSettings own = settings.world;
      own.threads = count;
      worlds_.emplace_back(own);
      worlds_.back().set_pair_filter([this](BodyId a, BodyId b) {
        strangers_ += std::this_thread::get_id() != caller_;
        return (a.index + b.index) % 11 != 5;
      });
    }
    make_shapes();
    for (int i = 0; i < settings.bodies; ++i)
      add();
  }

  void step() {
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      const double die = random_.uniform(0, 1);
      if (die < 0.01) {
        tell([&](World& world, std::size_t) { world.remove(ids_[i]); });
        ids_.erase(ids_.begin() + static_cast<std::ptrdiff_t>(i));
        add();
      } else if (die < 0.02) {
        tell([&](World& world, std::size_t) { world.sleep(ids_[i]); });
      } else if (die < 0.03) {
        const std::size_t other = any();
        tell([&](World& world, std::size_t w) { world.set_shape(ids_[i], shapes_[w][other]); });
      } else if (die < 0.04) {
        const Filter filter{.category = 1u << any() % 3, .mask = 3};
        tell([&](World& world, std::size_t) { world.set_filter(ids_[i], filter); });
      } else if (die < share_of_movers()) {
        const Pose pose = moved(worlds_[0].pose(ids_[i]));
        tell([&](World& world, std::size_t) { world.move(ids_[i], pose); });
      }
    }
    ++steps_;
    compare();
  }

  int strangers() const { return strangers_; }
  const WorldWork& work() const { return work_; }
  std::size_t contacts() const { return contacts_; }

 private:
  /// Each world has meshes of its own, so that each builds their trees.
  void make_shapes() {
    for (std::size_t w = 0; w < worlds_.size(); ++w) {
      RandomSource source(5);
      std::vector<std::shared_ptr<const BodyShape>> shapes;
      for (const ShapeKind kind :
           {ShapeKind::Box, ShapeKind::Sphere, ShapeKind::ConvexHull, ShapeKind::Capsule,
            ShapeKind::Cylinder, ShapeKind::Cone, ShapeKind::Ellipsoid, ShapeKind::Box})
        shapes.push_back(share(tests::random_shape(kind, 0.5, source)));
      for (const Mesh& mesh : {tests::make_torus(0.5, 0.2, 24, 12), tests::make_sphere(0.5, 8, 12),
                               tests::make_box({0.5, 0.25, 0.25})}) {
        if (settings_.are_trees_built) prepare(mesh), tree_of(mesh);
        shapes.push_back(share(mesh));
      }
      shapes.push_back(std::make_shared<UsersBall>(0.4, !settings_.has_shapes_for_caller));
      shapes.push_back(std::make_shared<UsersBall>(0.4, true));
      shapes_.push_back(shapes);
      Mesh floor = tests::make_box({20, 20, 0.5});
      if (settings_.are_trees_built) prepare(floor), tree_of(floor);
      worlds_[w].add({floor, at(0)}, {.kind = BodyKind::Static});
    }
  }

  std::size_t any() {
    return static_cast<std::size_t>(random_.integer(0, static_cast<int>(shapes_[0].size()) - 1));
  }

  Pose place() {
    Pose pose = tests::random_pose(1, random_);
    const double reach = 0.4 * std::cbrt(settings_.bodies);
    pose.translation() = random_.vector(-reach, reach);
    pose.translation().z() += reach;
    return pose;
  }

  Pose moved(Pose pose) {
    pose.rotate(Eigen::AngleAxisd(random_.uniform(-0.1, 0.1), Eigen::Vector3d::UnitX()));
    pose.translation() += random_.vector(-0.05, 0.05);
    return pose;
  }

  /// In turn nearly all move, half of them, and few.
  double share_of_movers() const { return steps_ % 3 == 0 ? 0.95 : steps_ % 3 == 1 ? 0.5 : 0.1; }

  void add() {
    const std::size_t shape = any();
    const Pose pose = place();
    BodySettings settings;
    if (random_.uniform(0, 1) < 0.1) settings.role = Role::Sensor;
    if (random_.uniform(0, 1) < 0.1) settings.kind = BodyKind::Kinematic;
    if (random_.uniform(0, 1) < 0.1) settings.filter.group = -1;
    BodyId id;
    tell([&](World& world, std::size_t w) { id = world.add({shapes_[w][shape], pose}, settings); });
    ids_.push_back(id);
  }

  template <typename Change>
  void tell(const Change& change) {
    for (std::size_t w = 0; w < worlds_.size(); ++w)
      change(worlds_[w], w);
  }

  void compare() {
    Digest expected;
    for (std::size_t w = 0; w < worlds_.size(); ++w) {
      const WorldUpdate update = worlds_[w].update();
      const Digest digest = told(worlds_[w], update);
      if (w == 0) {
        expected = digest, work_ = update.work;
        contacts_ += update.contacts.size();
      }
      EXPECT_TRUE(digest == expected) << "world " << w << ", step " << steps_;
      EXPECT_TRUE(update.work == work_) << "work of world " << w << ", step " << steps_;
    }
  }

  PileSettings settings_;
  std::vector<World> worlds_;
  std::vector<std::vector<std::shared_ptr<const BodyShape>>> shapes_;  // of each world
  std::vector<BodyId> ids_;
  RandomSource random_{3};
  std::thread::id caller_ = std::this_thread::get_id();
  std::atomic<int> strangers_ = 0;
  int steps_ = 0;
  WorldWork work_;
  std::size_t contacts_ = 0;
};

void expect_same_piles(const std::vector<int>& threads, int steps, const PileSettings& settings) {
  const tbb::global_control enough(tbb::global_control::max_allowed_parallelism, 8);
  Piles piles(threads, settings);
  Work shapes;
  for (int step = 0; step < steps && !testing::Test::HasFailure(); ++step) {
    piles.step();
    shapes += piles.work().shapes;
  }
  EXPECT_EQ(piles.strangers(), 0) << "a filter was asked by another thread";
  EXPECT_EQ(piles.contacts() > static_cast<std::size_t>(settings.bodies), settings.world.contacts);
  const bool are_trees_left = !settings.are_trees_built && settings.world.skip_unused_trees;
  EXPECT_EQ(shapes.trees_built > 0, are_trees_left);
  EXPECT_GT(shapes.convex_tests, 1000u);
}

TEST(SharedUpdate, SaysAndDoesTheSameForAnyNumberOfThreads) {
  expect_same_piles({1, 2, 4, 8}, 24, {});
  expect_same_piles({1, 2, 4, 8}, 24, {.has_shapes_for_caller = false});
}

TEST(SharedUpdate, SaysAndDoesTheSameWithoutSkipsAndContacts) {
  expect_same_piles(
      {1, 2, 0}, 12,
      {.has_shapes_for_caller = false, .world = {.skip_apart = false, .skip_at_rest = false}});
  expect_same_piles(
      {1, 2, 0}, 12,
      {.has_shapes_for_caller = false, .world = {.contacts = false, .skip_unused_trees = false}});
}

TEST(SharedUpdateThreads, SayAndDoTheSame) {
  for (const bool has_shapes_for_caller : {true, false})
    expect_same_piles(
        {1, 2, 4}, 6,
        {.are_trees_built = true, .has_shapes_for_caller = has_shapes_for_caller, .bodies = 150});
}

}  // namespace
}  // namespace graze
