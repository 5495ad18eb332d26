#include "samples/simulation/scenes/judgement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

namespace graze::samples {
namespace {

/// Returns a bound of how far the points of a body have come.
double moved(const RigidBody& now, const RigidBody& before) {
  const double turned = 2 * (now.turn * before.turn.conjugate()).vec().norm();
  return (now.at - before.at).norm() + std::min(turned, 2.0) * now.bounding_radius;
}

double speed_of(const RigidBody& body) {
  return body.velocity.norm() + body.spin.norm() * body.bounding_radius;
}

/// Raises the most to a value; NaN counts as worst.
void raise(double& most, double value) {
  if (!(value <= most)) most = value;
}

/// Says what falling explains: all that is high or fast at first comes down to where the lowest is.
class Falling {
 public:
  explicit Falling(const SceneRun& run) : gravity_(run.scene().gravity) {
    for (std::size_t i = 0; i < run.bodies().size(); ++i) {
      if (run.scene().bodies[i].hold == Hold::Fixed) continue;
      const RigidBody& body = run.bodies()[i];
      top_ = std::max(top_, body.at.z());
      fastest_ = std::max(fastest_, body.velocity.norm());
    }
    low_ = top_;
  }

  /// Returns the greatest excess over all bodies, m/s.
  double excess(const SceneRun& run) {
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < run.bodies().size(); ++i) {
      if (run.scene().bodies[i].hold != Hold::Free) continue;
      low_ = std::min(low_, run.bodies()[i].at.z());
      raise(most, run.bodies()[i].velocity.norm());
    }
    return most - std::sqrt(fastest_ * fastest_ + 2 * gravity_ * (top_ - low_));
  }

 private:
  double gravity_;
  double top_ = -std::numeric_limits<double>::infinity(), low_ = 0, fastest_ = 0;
};

}  // namespace

SceneReport run_scene(const Scene& scene, const std::function<void(const SceneRun&)>& look) {
  SceneRun run(scene);
  SceneReport report{.name = scene.name, .steps = scene.steps};
  Falling falling(run);
  report.excess = -std::numeric_limits<double>::infinity();
  const double first = run.energy();
  double least = first;
  const int last_part = scene.steps - scene.steps / 4;
  std::optional<std::vector<RigidBody>> before;
  for (int step = 0; step < scene.steps; ++step) {
    if (step == last_part) before = run.bodies();
    run.step();
    const double energy = run.energy();
    raise(report.energy, (energy - least) / first);
    least = std::min(least, energy);
    raise(report.excess, falling.excess(run));
    if (before) {
      for (std::size_t i = 0; i < before->size(); ++i) {
        raise(report.drift, moved(run.bodies()[i], (*before)[i]));
        raise(report.speed, speed_of(run.bodies()[i]));
      }
      raise(report.depth, run.depth());
      report.contacts += static_cast<double>(run.contact_count()) / (scene.steps - last_part);
    }
    if (look) look(run);
  }
  report.world_seconds = run.world_seconds();
  report.solver_seconds = run.solver_seconds();
  return report;
}

std::vector<std::string> complaints(const SceneReport& report, Outcome outcome,
                                    const SceneLimits& limits) {
  std::vector<std::string> result;
  const auto ask = [&](const char* what, double value, double limit, const char* unit) {
    if (value <= limit) return;
    char text[160];
    std::snprintf(text, sizeof text, "%s: %s is %.4g %s, at most %.4g is allowed",
                  report.name.c_str(), what, value, unit, limit);
    result.emplace_back(text);
  };
  if (outcome == Outcome::Shown) return result;
  if (outcome == Outcome::Rests) {
    ask("the drift at the end", report.drift, limits.drift, "m");
    ask("the speed at the end", report.speed, limits.speed, "m/s");
  }
  ask("the rise of energy", report.energy, limits.energy, "of what there was");
  ask("the speed beyond falling", report.excess, limits.excess, "m/s");
  return result;
}

}  // namespace graze::samples
