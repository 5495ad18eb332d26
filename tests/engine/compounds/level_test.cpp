// A level: compounds on a height field, with bodies that move among them, some fast, beside the
// same made of plain meshes and bodies. GRAZE_LEVEL_STEPS=N says how many steps the large one
// takes, and GRAZE_LEVEL_CELLS=N how many cells its field has along each side: a person may let it
// run for an hour.

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "tests/engine/compounds/twins.h"
#include "tests/engine/motion/moving_bodies.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

using tests::Twins;

struct LevelSettings {
  std::uint32_t side;  ///< heights along each side
  double spacing = 1;  ///< metres between them
  Eigen::Vector3d corner = {0, 0, 0};
  int compounds;
  int bodies;
  int steps;
  int questions;  ///< of each kind in each step

  double width() const { return spacing * (side - 1); }
};

double height_at(double x, double y) {
  return 2 * std::sin(0.3 * x) + 1.5 * std::cos(0.2 * y);
}

/// Metres above the ground.
double height_above(const LevelSettings& level, const Eigen::Vector3d& at) {
  const Eigen::Vector3d own = at - level.corner;
  return own.z() - height_at(own.x(), own.y());
}

/// Some metres above the ground, or in it.
Pose somewhere(RandomSource& source, const LevelSettings& level, double lowest, double highest) {
  Pose pose = tests::random_pose(source, 0);
  const double x = source.uniform(1, level.width() - 1), y = source.uniform(1, level.width() - 1);
  const double above = source.uniform(lowest, highest);
  pose.translation() = level.corner + Eigen::Vector3d(x, y, height_at(x, y) + above);
  return pose;
}

HeightField ground(const LevelSettings& level, RandomSource& source) {
  std::vector<float> heights;
  for (std::uint32_t row = 0; row < level.side; ++row) {
    for (std::uint32_t column = 0; column < level.side; ++column) {
      const double height = height_at(column * level.spacing, row * level.spacing);
      heights.push_back(static_cast<float>(height + source.uniform(0, 0.2 * level.spacing)));
    }
  }
  return HeightField(level.side, level.side, std::span<const float>(heights),
                     {.spacing_x = level.spacing, .spacing_y = level.spacing});
}

void fill(Twins& twins, const LevelSettings& level, RandomSource& source) {
  Pose corner = Pose::Identity();
  corner.translation() = level.corner;
  twins.add(Shape(ground(level, source)), corner, {.kind = BodyKind::Static});
  for (int i = 0; i < level.compounds; ++i) {
    const auto parts = static_cast<std::uint32_t>(source.integer(2, i % 10 == 0 ? 30 : 6));
    twins.add(tests::random_compound(source, parts, 1), somewhere(source, level, -0.5, 1),
              {.kind = BodyKind::Static});
  }
  for (int i = 0; i < level.bodies; ++i) {
    const Pose pose = somewhere(source, level, -0.2, 0.8);
    const BodySettings body{.margin = i % 4 == 0 ? 0.02 : 0,
                            .detection = i % 16 == 1 ? Detection::Continuous : Detection::Discrete};
    if (i % 8 == 0) {
      twins.add(tests::random_compound(source, 4, 0.5), pose, body);
    } else {
      twins.add(tests::random_small_shape(source, i), pose, body);
    }
  }
}

/// A third moves in each step, by little or, if it has left the ground's neighbourhood, back.
void move_some(Twins& twins, const LevelSettings& level, RandomSource& source) {
  const auto first = static_cast<std::uint32_t>(1 + level.compounds);
  for (std::uint32_t body = first; body < twins.size(); ++body) {
    if (source.integer(0, 2) != 0) continue;
    const Eigen::Vector3d before = twins.pose(body).translation();
    Pose next = tests::moved(source, twins.pose(body), 0.3, 0.4);
    const bool is_lost = std::abs(height_above(level, next.translation())) > 2;
    const bool is_fast = (body - first) % 16 == 1;
    if (is_lost || is_fast) next = somewhere(source, level, -0.2, 0.8);
    // A way across all of a large level meets thousands, which is not what a step is.
    if (is_fast) {
      const Eigen::Vector3d way = next.translation() - before;
      next.translation() = before + way * std::min(1.0, 8 / way.norm());
    }
    twins.move(body, next);
  }
}

struct Counts {
  std::size_t contacts = 0, answers = 0;
};

void ask_some(Twins& twins, const LevelSettings& level, RandomSource& source, Counts& counts) {
  for (int i = 0; i < level.questions; ++i) {
    const Pose from = somewhere(source, level, 0, 3);
    counts.answers += twins.ask(tests::random_small_shape(source, i), from, source.uniform(0, 0.5));
    const Eigen::Vector3d way = source.vector(-1, 1) - Eigen::Vector3d(0, 0, 0.5);
    counts.answers += twins.cast_ray({from.translation(), way, 40});
    const RigidCourse course{
        .centre = from.translation(), .shift = 3 * way, .axis = {0, 0, 1}, .angle = 1};
    counts.answers +=
        twins.cast_far(tests::random_small_shape(source, i), RigidMotion(from, course));
  }
}

Counts play(const LevelSettings& level, bool does_tell) {
  RandomSource source(level.side);
  Twins twins({.threads = 2});
  fill(twins, level, source);
  Counts counts;
  for (int step = 0; step < level.steps && !testing::Test::HasFailure(); ++step) {
    counts.contacts += twins.update();
    move_some(twins, level, source);
    ask_some(twins, level, source, counts);
    if (does_tell && step % 10 == 0)
      std::fprintf(stderr, "step %d of %d, %zu contacts and %zu answers are the same\n", step,
                   level.steps, counts.contacts, counts.answers);
  }
  return counts;
}

/// What the user says, or else the usual.
int setting(const char* name, int usual) {
  const char* text = std::getenv(name);
  if (text == nullptr) return usual;
  const std::string_view all = text;
  int value = 0;
  const auto [end, error] = std::from_chars(all.data(), all.data() + all.size(), value);
  if (error == std::errc() && end == all.data() + all.size() && value > 0) return value;
  ADD_FAILURE() << name << "=" << all << " is no positive number";
  return usual;
}

TEST(Level, IsWhatPlainMeshesAndBodiesAre) {
  const Counts counts =
      play({.side = 31, .compounds = 40, .bodies = 120, .steps = 8, .questions = 8}, false);
  EXPECT_GT(counts.contacts, 300u);
  EXPECT_GT(counts.answers, 100u);
}

TEST(Level, IsTheSameFarFromTheOrigin) {
  const Counts counts = play({.side = 61,
                              .spacing = 0.25,
                              .corner = {3000, -700, 40},
                              .compounds = 20,
                              .bodies = 60,
                              .steps = 4,
                              .questions = 8},
                             false);
  EXPECT_GT(counts.contacts, 100u);
  EXPECT_GT(counts.answers, 50u);
}

TEST(LevelSlow, InLargeIsWhatPlainMeshesAndBodiesAre) {
  const int steps = setting("GRAZE_LEVEL_STEPS", 40);
  const auto cells = static_cast<std::uint32_t>(setting("GRAZE_LEVEL_CELLS", 1024));
  const double spacing = 0.25;
  ASSERT_FALSE(HasFailure());
  const Counts counts = play({.side = cells + 1,
                              .spacing = spacing,
                              .corner = {-spacing * cells / 2, -spacing * cells / 2, 0},
                              .compounds = 10000,
                              .bodies = 5000,
                              .steps = steps,
                              .questions = 32},
                             true);
  const auto least = static_cast<std::size_t>(steps);
  EXPECT_GT(counts.contacts, 1000 * least);
  EXPECT_GT(counts.answers, 50 * least);
}

}  // namespace
}  // namespace graze
