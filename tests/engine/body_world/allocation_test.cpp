// A world whose bodies go round and round: once all has happened, nothing is allocated any more.

#include <graze/engine/world/world.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <vector>

#include "tests/engine/body_world/allocations.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/shape_kinds.h"

namespace graze {
namespace {

constexpr int kPeriod = 16;

/// Bodies of all kinds, each with a closed path. Where contacts are asked for, no two meshes meet:
/// theirs are lists of any length.
struct Merry {
  Merry(int count, const WorldSettings& settings) : world(settings) {
    RandomSource source(1);
    for (int i = 0; i < count; ++i) {
      const ShapeKind kind =
          tests::kOwnKinds[static_cast<std::size_t>(i) % tests::kOwnKinds.size()];
      if (kind == ShapeKind::HalfSpace && i > 54) continue;
      const BodyKind motion =
          kind == ShapeKind::HalfSpace ? BodyKind::Kinematic : BodyKind::Dynamic;
      const bool is_alone = kind == ShapeKind::Mesh && settings.contacts;
      const Role role = i % 7 == 0 ? Role::Sensor : Role::Solid;
      const Pose start = tests::random_pose(0.6 * std::cbrt(count), source);
      ids.push_back(
          world.add({tests::random_shape(kind, 0.8, source), start},
                    {.kind = motion, .filter = {.group = is_alone ? -1 : 0}, .role = role}));
      paths.emplace_back();
      const Eigen::Vector3d axis = source.vector(-1, 1).normalized();
      for (int k = 0; k < kPeriod; ++k) {
        Pose pose = start;
        pose.rotate(Eigen::AngleAxisd(6.283185307 * k / kPeriod, axis));
        pose.translation() += 0.2 * pose.linear().col(0);
        paths.back().push_back(pose);
      }
    }
  }

  /// Moves each as it should be in a frame: one by one, some, or all in one call.
  WorldUpdate step(int frame) {
    const auto k = static_cast<std::size_t>(frame % kPeriod);
    poses.clear();
    for (std::size_t i = 0; i < ids.size(); ++i)
      poses.push_back(paths[i][k]);
    if (frame % 4 == 0) {
      world.move(ids, poses);
    } else {
      for (std::size_t i = frame % 4 == 1 ? 0 : k; i < ids.size(); i += frame % 4 == 1 ? 1 : 5)
        world.move(ids[i], poses[i]);
    }
    return world.update();
  }

  World world;
  std::vector<BodyId> ids;
  std::vector<std::vector<Pose>> paths;
  std::vector<Pose> poses;
};

void expect_steady(int count, const WorldSettings& settings) {
  Merry merry(count, settings);
  const auto look = [&](int frame) {
    return merry.world.cast_ray({{-9, 0, 0}, {1, 0.01 * frame, 0}});
  };
  // Long enough that no new order of the broad phase falls due afterwards, which may allocate; and
  // that each mesh has met the first of its rays, which has its tree for rays made.
  for (int frame = 0; frame < 3 * kPeriod; ++frame) {
    merry.step(frame);
    static_cast<void>(look(frame));
  }
  std::size_t moved = 0, contacts = 0, began = 0;
  for (int frame = 0; frame < 2 * kPeriod; ++frame) {
    const std::size_t before = tests::allocations();
    const WorldUpdate update = merry.step(frame);
    const auto first = look(frame);
    EXPECT_EQ(tests::allocations(), before) << count << " bodies, frame " << frame;
    moved += update.moved.size(), contacts += update.contacts.size();
    began += update.begun.size() + first.has_value();
  }
  EXPECT_GT(moved, 1000u);
  EXPECT_GT(began, 50u);
  EXPECT_EQ(contacts > 500, settings.contacts);
}

TEST(Allocations, NoneInASteadyUpdate) {
  expect_steady(54, {});
  expect_steady(54, {.contacts = false});
  EXPECT_GT(tests::allocations(), 0u);
}

TEST(Allocations, NoneInASteadyUpdateOfMany) {
  expect_steady(500, {.contacts = false});
}

/// Each thread has memory of its own, which grows until it has met the pairs that need most.
TEST(Allocations, EndWhereThreadsShareAnUpdate) {
  const tbb::global_control enough(tbb::global_control::max_allowed_parallelism, 2);
  Merry merry(500, {.threads = 2, .contacts = false});
  constexpr int kMostRounds = 40;
  int steady = 0;
  for (int round = 0; round < kMostRounds && steady < 3; ++round) {
    const std::size_t before = tests::allocations();
    for (int frame = 0; frame < kPeriod; ++frame)
      EXPECT_FALSE(merry.step(frame).moved.empty());
    steady = tests::allocations() == before ? steady + 1 : 0;
  }
  EXPECT_EQ(steady, 3);
}

}  // namespace
}  // namespace graze
