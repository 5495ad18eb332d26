// A level: compounds on a height field, with bodies that move among them, some fast, beside the
// same made of plain meshes and bodies.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "tests/engine/compounds/twins.h"
#include "tests/engine/motion/moving_bodies.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

using tests::Twins;

struct LevelSettings {
  std::uint32_t side;  ///< heights along each side, 1 m apart
  int compounds;
  int bodies;
  int steps;
  int questions;  ///< of each kind in each step
};

double height_at(double x, double y) {
  return 2 * std::sin(0.3 * x) + 1.5 * std::cos(0.2 * y);
}

/// Some metres above the ground, or in it.
Pose somewhere(RandomSource& source, double side, double lowest, double highest) {
  Pose pose = tests::random_pose(source, 0);
  const double x = source.uniform(1, side - 2), y = source.uniform(1, side - 2);
  pose.translation() = Eigen::Vector3d(x, y, height_at(x, y) + source.uniform(lowest, highest));
  return pose;
}

Twins& fill(Twins& level, const LevelSettings& settings, RandomSource& source) {
  std::vector<float> heights;
  for (std::uint32_t row = 0; row < settings.side; ++row) {
    for (std::uint32_t column = 0; column < settings.side; ++column)
      heights.push_back(static_cast<float>(height_at(column, row) + source.uniform(0, 0.2)));
  }
  const HeightField field(settings.side, settings.side, std::span<const float>(heights));
  level.add(Shape(field), tests::at(0), {.kind = BodyKind::Static});
  for (int i = 0; i < settings.compounds; ++i) {
    const auto parts = static_cast<std::uint32_t>(source.integer(2, i % 10 == 0 ? 30 : 6));
    level.add(tests::random_compound(source, parts, 1), somewhere(source, settings.side, -0.5, 1),
              {.kind = BodyKind::Static});
  }
  for (int i = 0; i < settings.bodies; ++i) {
    const Pose pose = somewhere(source, settings.side, -0.2, 0.8);
    const BodySettings body{.margin = i % 4 == 0 ? 0.02 : 0,
                            .detection = i % 16 == 1 ? Detection::Continuous : Detection::Discrete};
    if (i % 8 == 0) {
      level.add(tests::random_compound(source, 4, 0.5), pose, body);
    } else {
      level.add(tests::random_small_shape(source, i), pose, body);
    }
  }
  return level;
}

/// A third moves in each step, by little or, if it has left the ground's neighbourhood, back.
void move_some(Twins& level, const LevelSettings& settings, RandomSource& source) {
  const auto first = static_cast<std::uint32_t>(1 + settings.compounds);
  for (std::uint32_t body = first; body < level.size(); ++body) {
    if (source.integer(0, 2) != 0) continue;
    Pose next = tests::moved(source, level.pose(body), 0.3, 0.4);
    const Eigen::Vector3d& at = next.translation();
    const bool is_lost = std::abs(at.z() - height_at(at.x(), at.y())) > 2;
    const bool is_fast = (body - first) % 16 == 1;
    if (is_lost || is_fast) next = somewhere(source, settings.side, -0.2, 0.8);
    // A way across all of a large level meets thousands, which is not what a step is.
    if (is_fast) {
      const Eigen::Vector3d way = next.translation() - level.pose(body).translation();
      next.translation() = level.pose(body).translation() + way * std::min(1.0, 8 / way.norm());
    }
    level.move(body, next);
  }
}

void play(const LevelSettings& settings, std::size_t least_contacts, std::size_t least_answers) {
  RandomSource source(settings.side);
  Twins level({.threads = 2});
  fill(level, settings, source);
  std::size_t contacts = 0, answers = 0;
  for (int step = 0; step < settings.steps && !testing::Test::HasFailure(); ++step) {
    contacts += level.update();
    move_some(level, settings, source);
    for (int i = 0; i < settings.questions; ++i) {
      const Pose from = somewhere(source, settings.side, 0, 3);
      answers += level.ask(tests::random_small_shape(source, i), from, source.uniform(0, 0.5));
      const Eigen::Vector3d way = source.vector(-1, 1) - Eigen::Vector3d(0, 0, 0.5);
      answers += level.cast_ray({from.translation(), way, 40});
      answers +=
          level.cast(tests::random_small_shape(source, i),
                     RigidMotion(from, {.shift = 3 * way, .axis = {0, 0, 1}, .angle = 1}), 1e-5);
    }
  }
  EXPECT_GT(contacts, least_contacts);
  EXPECT_GT(answers, least_answers);
}

TEST(Level, IsWhatPlainMeshesAndBodiesAre) {
  play({.side = 31, .compounds = 40, .bodies = 120, .steps = 8, .questions = 8}, 300, 100);
}

}  // namespace
}  // namespace graze
