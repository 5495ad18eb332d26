// A level: compounds on a height field, with bodies that move among them, some fast, beside the
// same made of plain meshes and bodies. GRAZE_LEVEL_STEPS=N says how many steps the large one
// takes, and GRAZE_LEVEL_CELLS=N how many cells its field has along each side: a person may let it
// run for an hour.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "tests/engine/compounds/level_scene.h"
#include "tests/engine/compounds/twins.h"
#include "tests/engine/motion/moving_bodies.h"

namespace graze {
namespace {

using tests::ask_some;
using tests::Counts;
using tests::height_above;
using tests::LevelSettings;
using tests::positive_setting;
using tests::somewhere;
using tests::Twins;

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

Counts play(const LevelSettings& level, bool does_tell) {
  RandomSource source(level.side);
  Twins twins({.threads = 2});
  fill_level(twins, level, source);
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
  const int steps = positive_setting("GRAZE_LEVEL_STEPS", 40);
  const auto cells = static_cast<std::uint32_t>(positive_setting("GRAZE_LEVEL_CELLS", 1024));
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
