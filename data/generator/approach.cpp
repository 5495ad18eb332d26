#include "data/generator/approach.h"

#include <graze/engine/mesh/pair.h>

#include <stdexcept>

namespace graze::generator {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr int kPoses = 36;
constexpr int kMostDraws = 40 * kPoses;
constexpr double kStepsPerSize = 32;
constexpr int kHalvings = 36;  // 2^-36 / 32 is about a part in 10^12

bool hits(const ApproachPair& pair, const Isometry3d& pose) {
  return intersects({pair.mesh_a}, {pair.mesh_b, pose});
}

// The sums are spelled out: Eigen's order of adding depends on how it vectorises.
Vector3d turned(const Eigen::Matrix3d& rotation, const Vector3d& p) {
  return rotation.col(0) * p.x() + rotation.col(1) * p.y() + rotation.col(2) * p.z();
}

double halved(const ApproachPair& pair, const Approach& approach, double clear, double hit) {
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (clear + hit) / 2;
    (hits(pair, at_distance(pair, approach, middle)) ? hit : clear) = middle;
  }
  return hit;
}

}  // namespace

Isometry3d at_distance(const ApproachPair& pair, const Approach& approach, double distance) {
  const Aabb& bounds = pair.mesh_b.bounds();
  const Vector3d middle = (bounds.min + bounds.max) / 2;
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() = approach.rotation;
  pose.translation() =
      approach.start + distance * approach.direction - turned(approach.rotation, middle);
  return pose;
}

std::optional<double> first_touch(const ApproachPair& pair, const Approach& approach) {
  const double step = pair.size / kStepsPerSize;
  if (hits(pair, at_distance(pair, approach, 0))) return std::nullopt;
  for (int i = 1; i * step <= approach.length; ++i) {
    const double here = i * step;
    if (hits(pair, at_distance(pair, approach, here))) {
      return halved(pair, approach, here - step, here);
    }
  }
  return std::nullopt;
}

Regime far_regime(const std::string& file) {
  return {file, false, [](Dice& dice, int) { return -dice.uniform(1, 4); }};
}

Regime near_regime(const std::string& file) {
  constexpr double kSteps[] = {0.001, 0.01, 0.05};
  return {file, false, [=](Dice&, int index) { return -kSteps[index % 3]; }};
}

Regime touch_regime(const std::string& file) {
  return {file, true, [](Dice& dice, int) { return dice.uniform(0.001, 0.01); }};
}

Regime deep_regime(const std::string& file) {
  return {file, true, [](Dice& dice, int) { return dice.uniform(0.1, 0.5); }};
}

PoseList approach(const ApproachPair& pair, const Regime& regime, Dice& dice) {
  PoseList list{regime.file, {}};
  for (int draw = 0; draw < kMostDraws && list.poses.size() < kPoses; ++draw) {
    const Approach drawn = pair.draw(dice);
    const double step = pair.size * regime.step(dice, static_cast<int>(list.poses.size()));
    const std::optional<double> touch = first_touch(pair, drawn);
    if (!touch) continue;
    const Isometry3d pose = at_distance(pair, drawn, *touch + step);
    if (hits(pair, pose) == regime.is_hit) list.poses.push_back(pose);
  }
  if (list.poses.size() < kPoses) {
    throw std::runtime_error(regime.file + ": too few poses do as they should");
  }
  return list;
}

}  // namespace graze::generator
