#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <stdexcept>
#include <thread>

#include "tests/engine/floating_point/environments.h"
#include "tests/engine/floating_point/questions.h"
#include "tests/shapes/closed_meshes.h"

namespace graze::tests {
namespace {

/// A shape of a user's own that remembers how it was asked, and may throw.
class Witness : public BodyShape {
 public:
  bool allows_concurrent_calls() const override {
    note();
    return is_concurrent;
  }
  Aabb bounds(const Pose&) const override {
    note();
    return {Eigen::Vector3d::Constant(-1), Eigen::Vector3d::Constant(1)};
  }
  bool touches(const Pose&, const BodyShape&, const Pose&) const override {
    note();
    if (is_concurrent) wait_for_another();
    if (throws) throw std::runtime_error("a user's own");
    return is_hit;
  }
  Manifold contacts(const Pose&, const BodyShape&, const Pose&) const override {
    note();
    return {};
  }
  double gap(const Pose&, const BodyShape&, const Pose&) const override {
    note();
    return 0;
  }
  std::optional<RayHit> cast_ray(const Pose&, const Ray&) const override {
    note();
    return std::nullopt;
  }
  double bounding_radius() const override {
    note();
    return 2;
  }

  void note() const {
    ++calls;
    if (current_control() != expected) ++wrong;
  }
  /// Until two threads have asked it, for a while.
  void wait_for_another() const {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    const auto own = std::hash<std::thread::id>{}(std::this_thread::get_id());
    std::size_t none = 0;
    if (first_thread.compare_exchange_strong(none, own) || none == own) {
      while (!has_met_two && std::chrono::steady_clock::now() < end)
        std::this_thread::yield();
    } else {
      has_met_two = true;
    }
  }
  std::uint32_t expected = 0;
  bool is_hit = true;
  bool throws = false;
  bool is_concurrent = false;
  mutable std::atomic<int> calls = 0, wrong = 0;
  mutable std::atomic<std::size_t> first_thread = 0;
  mutable std::atomic<bool> has_met_two = false;
};

Pose at(double x) {
  Pose pose = Pose::Identity();
  pose.translation().x() = x;
  return pose;
}

/// A world in which a witness stands before and behind a ball and beside another witness.
void meet_in_world(const Environment& environment, bool is_hit, Witness& witness) {
  witness.expected = environment.control;
  witness.is_hit = is_hit;
  const std::shared_ptr<const BodyShape> shared(&witness, [](const BodyShape*) {});
  const Shape ball(Sphere{{0, 0, 0}, 1});
  const InEnvironment in(environment);
  World world;
  int filtered = 0, filtered_wrongly = 0;
  world.set_pair_filter([&](BodyId, BodyId) {
    ++filtered;
    filtered_wrongly += current_control() != environment.control;
    return true;
  });
  const BodyId first = world.add({shared, at(0.25)});
  world.add({ball, at(0)});
  world.add({shared, at(0.5)});
  world.update();
  world.contacts();
  world.cast_ray({{0, 0, 4}, {0, 0, -1}});
  world.find_touching({ball, at(0)});
  const WorldSnapshot snapshot = world.snapshot();
  for (int i = 0; i < 5; ++i) {
    world.move(first, at(0.125));
    world.update();
  }
  world.restore(snapshot);
  world.set_shape(first, shared);
  world.update();
  EXPECT_EQ(current_control(), environment.control) << environment.name;
  EXPECT_GT(filtered, 0);
  EXPECT_EQ(filtered_wrongly, 0) << environment.name;
}

TEST(UsersArithmetic, IsThatOfUsersOwnShapesAndFilters) {
  for (const Environment& environment : all_environments()) {
    for (const bool is_hit : {false, true}) {
      Witness witness;
      meet_in_world(environment, is_hit, witness);
      EXPECT_GT(witness.calls, 10);
      EXPECT_EQ(witness.wrong, 0) << environment.name;
    }
  }
}

/// On whichever thread a world asks them.
TEST(UsersArithmetic, IsThatOfUsersOwnShapesOnOtherThreads) {
  const tbb::global_control enough(tbb::global_control::max_allowed_parallelism, 4);
  for (const Environment& environment : all_environments()) {
    for (const bool is_concurrent : {false, true}) {
      Witness witness;
      witness.expected = environment.control;
      witness.is_concurrent = is_concurrent;
      const std::shared_ptr<const BodyShape> shared(&witness, [](const BodyShape*) {});
      const InEnvironment in(environment);
      World world({.threads = 4});
      for (int i = 0; i < 100; ++i) {
        world.add({shared, at(0.25 * i)});
        world.add({Shape(Sphere{{0, 0, 0}, 1}), at(0.25 * i)});
      }
      EXPECT_GT(world.update().moved.size(), 400u);
      EXPECT_EQ(current_control(), environment.control) << environment.name;
      EXPECT_EQ(witness.wrong, 0) << environment.name;
      EXPECT_EQ(witness.has_met_two, is_concurrent) << environment.name;
    }
  }
}

TEST(UsersArithmetic, IsBackAfterAnException) {
  for (const Environment& environment : all_environments()) {
    Witness witness;
    witness.expected = environment.control;
    witness.throws = true;
    const std::shared_ptr<const BodyShape> shared(&witness, [](const BodyShape*) {});
    const InEnvironment in(environment);
    World world;
    world.add({shared, at(0)});
    world.add({Shape(Sphere{{0, 0, 0}, 1}), at(0)});
    EXPECT_THROW(world.update(), std::runtime_error);
    EXPECT_EQ(current_control(), environment.control) << environment.name;
    Pose bad = at(0);
    bad.linear() *= 2;
    EXPECT_THROW(world.add({Shape(Sphere{{0, 0, 0}, 1}), bad}), PoseError);
    EXPECT_EQ(current_control(), environment.control) << environment.name;
    EXPECT_EQ(witness.wrong, 0) << environment.name;
  }
}

TEST(UsersArithmetic, IsThatOfVisitorsOfBoxes) {
  for (const Environment& environment : all_environments()) {
    const InEnvironment in(environment);
    BroadPhase boxes;
    for (int i = 0; i < 3; ++i)
      boxes.add({Eigen::Vector3d::Constant(-1), Eigen::Vector3d::Constant(1)});
    int visited = 0, wrong = 0;
    boxes.visit_along({{0, 0, 4}, {0, 0, -1}}, [&](std::uint32_t) {
      ++visited;
      wrong += current_control() != environment.control;
      return 10.0;
    });
    EXPECT_EQ(visited, 3);
    EXPECT_EQ(wrong, 0) << environment.name;
    const auto throwing = [](std::uint32_t) -> double { throw std::runtime_error("a visitor"); };
    EXPECT_THROW(boxes.visit_along({{0, 0, 4}, {0, 0, -1}}, throwing), std::runtime_error);
    EXPECT_EQ(current_control(), environment.control);
  }
}

/// On whichever thread.
TEST(UsersArithmetic, IsThatOfReportsOfProgress) {
  const Inputs inputs = large_inputs(Scale::Unit, 12);
  for (const Environment& environment : all_environments()) {
    std::atomic<int> reports = 0, wrong = 0;
    const Mesh mesh(inputs.vertices_a, inputs.triangles_a);
    const auto note = [&](std::size_t, std::size_t) {
      ++reports;
      wrong += current_control() != environment.control;
    };
    const InEnvironment in(environment);
    find_voxels(mesh, {.resolution = 60, .threads = 4, .on_progress = note});
    EXPECT_GT(reports, 1);
    EXPECT_EQ(wrong, 0) << environment.name;
  }
}

/// Doors within callbacks within doors, and a callback that sets what it likes.
TEST(UsersArithmetic, IsNested) {
  const Environment& outer = all_environments()[1];
  const Environment& inner = all_environments().back();
  const InEnvironment in(outer);
  const std::uint64_t standard = all_environments()[0].control;
  bvh::in_standard_arithmetic([&] {
    EXPECT_EQ(current_control(), standard);
    bvh::in_users_arithmetic([&] {
      EXPECT_EQ(current_control(), outer.control);
      bvh::in_standard_arithmetic([&] {
        EXPECT_EQ(current_control(), standard);
        bvh::in_users_arithmetic([&] { EXPECT_EQ(current_control(), outer.control); });
        EXPECT_EQ(current_control(), standard);
      });
      EXPECT_EQ(current_control(), outer.control);
    });
    EXPECT_EQ(current_control(), standard);
    bvh::in_users_arithmetic([&] { bvh::write_control_word(inner.control); });
    EXPECT_EQ(current_control(), standard);
    EXPECT_EQ(bvh::users_control_word(), outer.control);
  });
  EXPECT_EQ(current_control(), outer.control);
}

/// What is returned passes through the call by address as through any other: values that can only
/// be moved, references, nothing.
TEST(UsersArithmetic, ReturnsWhatIsReturned) {
  for (const Environment& environment : all_environments()) {
    const InEnvironment in(environment);
    int one = 1;
    int& itself = bvh::in_standard_arithmetic([&]() -> int& { return one; });
    EXPECT_EQ(&itself, &one) << environment.name;
    const auto moved = bvh::in_standard_arithmetic([&] { return std::make_unique<int>(one); });
    EXPECT_EQ(*moved, 1) << environment.name;
    EXPECT_THROW(bvh::in_standard_arithmetic([] { throw InputError("thrown"); }), InputError);
    EXPECT_EQ(current_control(), environment.control);
  }
}

}  // namespace
}  // namespace graze::tests
