#include "tests/engine/compounds/level_scene.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "tests/engine/motion/moving_bodies.h"

namespace graze::tests {
namespace {

double height_at(double x, double y) {
  return 2 * std::sin(0.3 * x) + 1.5 * std::cos(0.2 * y);
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

}  // namespace

double height_above(const LevelSettings& level, const Eigen::Vector3d& at) {
  const Eigen::Vector3d own = at - level.corner;
  return own.z() - height_at(own.x(), own.y());
}

Pose somewhere(RandomSource& source, const LevelSettings& level, double lowest, double highest) {
  Pose pose = random_pose(source, 0);
  const double x = source.uniform(1, level.width() - 1), y = source.uniform(1, level.width() - 1);
  const double above = source.uniform(lowest, highest);
  pose.translation() = level.corner + Eigen::Vector3d(x, y, height_at(x, y) + above);
  return pose;
}

void fill_level(Twins& twins, const LevelSettings& level, RandomSource& source) {
  Pose corner = Pose::Identity();
  corner.translation() = level.corner;
  twins.add(Shape(ground(level, source)), corner, {.kind = BodyKind::Static});
  for (int i = 0; i < level.compounds; ++i) {
    const auto parts = static_cast<std::uint32_t>(source.integer(2, i % 10 == 0 ? 30 : 6));
    const auto compound = random_compound(source, parts, 1);
    twins.add(compound, somewhere(source, level, -0.5, 1), {.kind = BodyKind::Static});
  }
  for (int i = 0; i < level.bodies; ++i) {
    const Pose pose = somewhere(source, level, -0.2, 0.8);
    const BodySettings body{.margin = i % 4 == 0 ? 0.02 : 0,
                            .detection = i % 16 == 1 ? Detection::Continuous : Detection::Discrete};
    if (i % 8 == 0) {
      twins.add(random_compound(source, 4, 0.5), pose, body);
    } else {
      twins.add(random_small_shape(source, i), pose, body);
    }
  }
}

void ask_some(Twins& twins, const LevelSettings& level, RandomSource& source, Counts& counts) {
  for (int i = 0; i < level.questions; ++i) {
    const Pose from = somewhere(source, level, 0, 3);
    const Shape asked = random_small_shape(source, i);
    counts.answers += twins.ask(asked, from, source.uniform(0, 0.5));
    const Eigen::Vector3d way = source.vector(-1, 1) - Eigen::Vector3d(0, 0, 0.5);
    counts.answers += twins.cast_ray({from.translation(), way, 40});
    const RigidCourse course{
        .centre = from.translation(), .shift = 3 * way, .axis = {0, 0, 1}, .angle = 1};
    counts.answers += twins.cast_far(random_small_shape(source, i), RigidMotion(from, course));
  }
}

int positive_setting(const char* name, int usual) {
  const char* text = std::getenv(name);
  if (text == nullptr) return usual;
  const std::string_view all = text;
  int value = 0;
  const auto [end, error] = std::from_chars(all.data(), all.data() + all.size(), value);
  if (error == std::errc() && end == all.data() + all.size() && value > 0) return value;
  ADD_FAILURE() << name << "=" << all << " is no positive number";
  return usual;
}

}  // namespace graze::tests
