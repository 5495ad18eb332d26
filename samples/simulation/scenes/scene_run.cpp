#include "samples/simulation/scenes/scene_run.h"

#include <graze/bvh/error.h>

#include <algorithm>
#include <ctime>
#include <limits>

#include "samples/simulation/integrator.h"
#include "samples/simulation/shape_mass.h"

namespace graze::samples {
namespace {

using Eigen::Vector3d;

double core_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Changes the mass of a body that is held. A body on an axle yields to no push and to no moment
/// but one about its z axis; one that a motor turns yields to none. The energy of such a body is
/// that of its spin.
void hold(MassProperties& mass, Hold how) {
  if (how == Hold::Free) return;
  const double along = mass.inverse_inertia(2, 2);
  mass.mass = std::numeric_limits<double>::infinity();
  mass.inverse_inertia.setZero();
  if (how == Hold::Axle) mass.inverse_inertia(2, 2) = along;
}

bool has_weight(const RigidBody& body) {
  return body.mass->mass < std::numeric_limits<double>::infinity();
}

/// Returns the solver's settings, whose step is the substep.
SolverSettings solver_settings(const Scene& scene) {
  SolverSettings settings = scene.solver;
  settings.step = scene.step / scene.substeps;
  return settings;
}

}  // namespace

SceneRun::SceneRun(const Scene& scene) : scene_(scene), solver_(solver_settings(scene)) {
  for (const SceneBody& body : scene_.bodies)
    add(body);
}

void SceneRun::add(const SceneBody& body) {
  MassProperties mass{1, Vector3d::Zero(), Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero()};
  const bool is_fixed = body.hold == Hold::Fixed;
  if (is_fixed) {
    mass.mass = std::numeric_limits<double>::infinity();
  } else {
    mass = mass_properties(body.shape, body.density);
    hold(mass, body.hold);
  }
  masses_.push_back(mass);
  RigidBody rigid{.id = {},
                  .mass = &masses_.back(),
                  .at = body.pose * mass.centre,
                  .turn = Eigen::Quaterniond(body.pose.linear()),
                  .velocity = body.velocity,
                  .spin = body.spin,
                  .bounding_radius = is_fixed ? 0 : bounding_radius_about(body.shape, mass.centre),
                  .friction = body.friction};
  // Fixed bodies are among the solver's, too, because each has its own friction.
  rigid.id = world_.add(
      PlacedShapeView{body.shape, body.pose},
      {.kind = is_fixed ? BodyKind::Static : BodyKind::Dynamic, .user_data = bodies_.size()});
  bodies_.push_back(rigid);
}

void SceneRun::step() {
  const double begin = core_seconds();
  const WorldUpdate update = world_.update();
  const double middle = core_seconds();
  depth_ = 0;
  for (const BodyContact& contact : update.contacts) {
    for (const ShapeContact& point : contact.manifold)
      depth_ = std::max(depth_, point.depth);
  }
  solver_.take(world_, update, bodies_, woken_);
  for (int i = 0; i < scene_.substeps; ++i)
    substep(scene_.step / scene_.substeps);
  ids_.clear(), poses_.clear();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (scene_.bodies[i].hold == Hold::Fixed) continue;
    ids_.push_back(bodies_[i].id);
    poses_.push_back(bodies_[i].pose());
  }
  const double end = core_seconds();
  world_.move(ids_, poses_);
  world_seconds_ += (middle - begin) + (core_seconds() - end);
  solver_seconds_ += end - middle;
  ++steps_;
}

void SceneRun::substep(double seconds) {
  for (RigidBody& body : bodies_) {
    if (!has_weight(body)) continue;
    body.velocity.z() -= scene_.gravity * seconds;
    precess(body, seconds);
  }
  solver_.solve(bodies_, woken_);
  for (RigidBody& body : bodies_)
    advance(body, seconds);
  solver_.relax(bodies_);
}

const RigidBody& SceneRun::body(const std::string& name) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (scene_.bodies[i].name == name) return bodies_[i];
  }
  throw InputError("scene " + scene_.name + ": no body is called " + name);
}

double SceneRun::energy() const {
  double sum = 0;
  for (const RigidBody& body : bodies_) {
    const Vector3d spin = body.turn.conjugate() * body.spin;
    sum += 0.5 * spin.dot(body.mass->inertia * spin);
    if (!has_weight(body)) continue;
    sum += body.mass->mass * (0.5 * body.velocity.squaredNorm() + scene_.gravity * body.at.z());
  }
  return sum;
}

}  // namespace graze::samples
