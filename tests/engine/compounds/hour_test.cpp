// An hour of a level: 216,000 steps, of which some are compared with the same level made of plain
// meshes and bodies, and others before these are taken by the world of compounds alone. Where a
// body is at a time is a formula, so that any step can be gone to.
//
//   GRAZE_HOUR_EVERY=N     each N-th step is compared; usually one a minute
//   GRAZE_HOUR_BETWEEN=N   how many steps before each of these the world takes; N of EVERY: all
//   GRAZE_HOUR_BODIES=N    bodies that move; there are twice as many compounds
//   GRAZE_HOUR_CELLS=N     of the field along each side

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "tests/engine/compounds/level_scene.h"
#include "tests/engine/compounds/twins.h"
#include "tests/engine/motion/moving_bodies.h"

namespace graze {
namespace {

using tests::Counts;
using tests::LevelSettings;
using tests::positive_setting;
using tests::Twins;

constexpr int kStepsOfAnHour = 60 * 3600;
constexpr double kTurn = 6.283185307179586;

/// Some time it goes around a loop over the ground and turns, and then it rests for twice as long.
struct Round {
  Pose start;
  double above;     // the ground
  double radius;    // metres, of the loop
  double per_loop;  // outings that close it
  double period;    // seconds, of an outing and the rest after it
  double phase;     // of the period
  double spin;      // radians an outing
  Eigen::Vector3d axis;

  /// How far it has come, in outings.
  double outings(double seconds) const {
    const double periods = seconds / period + phase;
    return std::floor(periods) + std::min(1.0, 3 * (periods - std::floor(periods)));
  }

  Pose at(const LevelSettings& level, double seconds) const {
    const double gone = outings(seconds), angle = kTurn * gone / per_loop;
    Pose pose = start;
    pose.linear() = Eigen::AngleAxisd(spin * gone, axis).toRotationMatrix() * start.linear();
    pose.translation() += radius * Eigen::Vector3d(std::cos(angle) - 1, std::sin(angle), 0);
    const double wanted = above + 0.3 * std::sin(0.37 * kTurn * gone);
    pose.translation().z() += wanted - tests::height_above(level, pose.translation());
    return pose;
  }
};

std::vector<Round> rounds_of(const Twins& twins, const LevelSettings& level, RandomSource& source) {
  std::vector<Round> rounds;
  const auto first = static_cast<std::uint32_t>(1 + level.compounds);
  for (std::uint32_t body = first; body < twins.size(); ++body) {
    const bool is_fast = (body - first) % 16 == 1;  // those that are swept
    const Pose& start = twins.pose(body);
    rounds.push_back({.start = start,
                      .above = tests::height_above(level, start.translation()),
                      .radius = is_fast ? 6 : source.uniform(0.5, 2),
                      .per_loop = is_fast ? 1.0 : 5.0,
                      .period = is_fast ? 2 : source.uniform(4, 20),
                      .phase = source.uniform(0, 1),
                      .spin = source.uniform(-2, 2),
                      .axis = source.vector(-1, 1).normalized()});
  }
  return rounds;
}

/// Calls `move(body, pose)` for those that are elsewhere at a step.
template <typename Move>
void move_to_step(const Twins& twins, const LevelSettings& level, const std::vector<Round>& rounds,
                  int step, const Move& move) {
  const auto first = static_cast<std::uint32_t>(1 + level.compounds);
  for (std::uint32_t body = first; body < twins.size(); ++body) {
    const Pose next = rounds[body - first].at(level, step / 60.0);
    if (next.matrix() != twins.pose(body).matrix()) move(body, next);
  }
}

/// A compound of the level gets a part, another one or one fewer.
void rebuild_one(Twins& twins, const LevelSettings& level, RandomSource& source) {
  const auto body = static_cast<std::uint32_t>(source.integer(1, level.compounds));
  Compound changed = twins.compound(body);
  const std::vector<std::uint32_t> parts = changed.parts();
  const Shape shape = tests::random_small_shape(source, static_cast<int>(source.integer(0, 5)));
  const PlacedShape next{shape, tests::random_pose(source, 1)};
  const auto what = static_cast<int>(source.integer(0, 2));
  if (what == 0) changed.add(next);
  if (what == 1) changed.replace(parts[0], next);
  if (what == 2 && parts.size() > 1) changed.remove(parts.back());
  twins.set_compound(body, changed);
}

struct HourSettings {
  int every;
  int between;
};

/// Compared are steps `every`, twice as many, and so on; the world is at the step before each.
Counts play_hour(const LevelSettings& level, const HourSettings& hour, bool does_tell) {
  using Clock = std::chrono::steady_clock;
  RandomSource source(level.side);
  Twins twins({.threads = 2});
  fill_level(twins, level, source);
  twins.update();
  const std::vector<Round> rounds = rounds_of(twins, level, source);
  const auto move_alone = [&](std::uint32_t body, const Pose& pose) {
    twins.move_alone(body, pose);
  };
  const auto move = [&](std::uint32_t body, const Pose& pose) { twins.move(body, pose); };
  Counts counts;
  std::size_t taken = 0;
  Clock::time_point told = Clock::now();
  for (int step = hour.every; step <= kStepsOfAnHour; step += hour.every) {
    for (int on = step - std::clamp(hour.between, 1, hour.every); on < step; ++on, ++taken) {
      move_to_step(twins, level, rounds, on, move_alone);
      twins.update_alone();
    }
    twins.catch_up();
    if (testing::Test::HasFailure()) return counts;
    rebuild_one(twins, level, source);
    move_to_step(twins, level, rounds, step, move);
    counts.contacts += twins.update();
    ++taken;
    ask_some(twins, level, source, counts);
    if (does_tell && Clock::now() - told > std::chrono::seconds(2)) {
      told = Clock::now();
      std::fprintf(
          stderr, "minute %.1f of 60, %zu steps taken, %zu contacts and %zu answers are the same\n",
          step / 3600.0, taken, counts.contacts, counts.answers);
    }
  }
  return counts;
}

TEST(LevelHour, IsWhatPlainMeshesAndBodiesAre) {
  const Counts counts = play_hour({.side = 61,
                                   .spacing = 0.25,
                                   .corner = {-7.5, -7.5, 0},
                                   .compounds = 40,
                                   .bodies = 60,
                                   .steps = 0,
                                   .questions = 4},
                                  {.every = kStepsOfAnHour / 8, .between = 4}, false);
  EXPECT_GT(counts.contacts, 200u);
  EXPECT_GT(counts.answers, 50u);
}

TEST(LevelHourSlow, IsWhatPlainMeshesAndBodiesAre) {
  const HourSettings hour{.every = positive_setting("GRAZE_HOUR_EVERY", 3600),
                          .between = positive_setting("GRAZE_HOUR_BETWEEN", 60)};
  const int bodies = positive_setting("GRAZE_HOUR_BODIES", 150);
  const auto cells = static_cast<std::uint32_t>(positive_setting("GRAZE_HOUR_CELLS", 256));
  ASSERT_FALSE(HasFailure());
  const double spacing = 0.25;
  const Counts counts = play_hour({.side = cells + 1,
                                   .spacing = spacing,
                                   .corner = {-spacing * cells / 2, -spacing * cells / 2, 0},
                                   .compounds = 2 * bodies,
                                   .bodies = bodies,
                                   .steps = 0,
                                   .questions = 8},
                                  hour, true);
  EXPECT_GT(counts.contacts, static_cast<std::size_t>(kStepsOfAnHour / hour.every));
  EXPECT_GT(counts.answers, static_cast<std::size_t>(kStepsOfAnHour / hour.every));
}

}  // namespace
}  // namespace graze
