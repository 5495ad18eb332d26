#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/scenes/simulation.h>

#include <graze/bvh/error.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace graze {
namespace {

[[noreturn]] void refuse(const Scene& scene, std::size_t index, double time,
                         const PoseError& error) {
  ErrorPlace place = error.place();
  place.element = "body";
  place.index = index;
  throw PoseError("body \"" + scene.bodies[index].name + "\" at " + std::to_string(time) +
                      " s: " + error.what(),
                  std::move(place));
}

/// Throws for a turn that is too large: a body that is swept goes the short way from pose to pose.
void check_turn(const SceneBody& body, std::size_t index, double step) {
  const auto* path = std::get_if<SteadyPath>(&body.path);
  if (body.detection == Detection::Discrete || path == nullptr) return;
  if (std::abs(path->rate) * step < 0.5) return;
  throw InputError("body \"" + body.name + "\" turns by half a turn or more in a step of " +
                       std::to_string(step) + " s: it cannot be swept the long way round",
                   {.element = "body", .index = index});
}

}  // namespace

Simulation::Simulation(const Scene& scene, const SimulationSettings& settings)
    : scene_(scene),
      step_(settings.step == 0 ? scene.step : settings.step),
      world_(settings.world) {
  bvh::in_standard_arithmetic([&] {
    if (!(step_ > 0) || !std::isfinite(step_)) {
      throw InputError("the step of a simulation is not a positive number of seconds");
    }
    std::vector<std::shared_ptr<const BodyShape>> shapes;
    shapes.reserve(scene.shapes.size());
    for (const SceneShape& shape : scene.shapes)
      shapes.push_back(share(shape.shape));
    ids_.reserve(scene.bodies.size());
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const SceneBody& body = scene.bodies[i];
      check_turn(body, i, step_);
      const auto shape = body.parts.empty() ? shapes[body.shape] : body_shape(scene, body);
      ids_.push_back(
          world_.add({shape, pose_at(body, 0)},
                     {.kind = body.kind, .filter = body.filter, .detection = body.detection}));
    }
    for (const ScenePair& exclusion : scene.exclusions)
      world_.exclude(ids_[exclusion.a], ids_[exclusion.b]);
  });
}

WorldUpdate Simulation::advance() {
  return bvh::in_standard_arithmetic([&]() -> WorldUpdate {
    ++count_;
    try {
      if (count_ > 1) move_bodies();
      return world_.update();
    } catch (...) {
      --count_;  // bodies that were moved are where the next call wants them
      throw;
    }
  });
}

void Simulation::move_bodies() {
  bvh::in_standard_arithmetic([&] {
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      const SceneBody& body = scene_.bodies[i];
      if (std::holds_alternative<std::monostate>(body.path)) continue;
      const Pose pose = pose_at(body, time());
      if (pose.matrix() == world_.pose(ids_[i]).matrix()) continue;
      try {
        world_.move(ids_[i], pose);
      } catch (const PoseError& error) {
        refuse(scene_, i, time(), error);
      }
    }
  });
}

// Positions between keys lie between theirs, and a steady path leads away from its start or
// nowhere.
void check_paths(const Scene& scene, double end) {
  bvh::in_standard_arithmetic([&] {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const SceneBody& body = scene.bodies[i];
      try {
        body_shape(scene, body)->bounds(pose_at(body, end));
      } catch (const PoseError& error) {
        refuse(scene, i, end, error);
      }
    }
  });
}

}  // namespace graze
