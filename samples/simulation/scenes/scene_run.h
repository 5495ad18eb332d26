#pragma once

#include <graze/engine/world/world.h>

#include <deque>
#include <vector>

#include "samples/simulation/contact_solver.h"
#include "samples/simulation/scenes/scene.h"

namespace graze::samples {

/// Runs a scene: a world, the solver, and the loop around both. Nobody sleeps, and the world is
/// told of every move: bodies that rest do so by their contacts.
class SceneRun {
 public:
  explicit SceneRun(const Scene& scene);

  /// Finds contacts, solves them, moves the bodies.
  void step();

  const Scene& scene() const { return scene_; }
  double time() const { return steps_ * scene_.step; }  ///< seconds since it began
  int steps() const { return steps_; }

  /// Returns the bodies in the scene's order, fixed ones included.
  const std::vector<RigidBody>& bodies() const { return bodies_; }
  /// Returns the body of a name. Throws InputError if there is none.
  const RigidBody& body(const std::string& name) const;

  /// Returns the kinetic and potential energy, joules; the latter is 0 at z = 0.
  double energy() const;
  /// Return the deepest contact of the last step, metres, and how many contacts there were.
  double depth() const { return depth_; }
  std::size_t contact_count() const { return solver_.contact_count(); }

  /// Return the seconds of one core since the run began: finding contacts, and solving them.
  double world_seconds() const { return world_seconds_; }
  double solver_seconds() const { return solver_seconds_; }

 private:
  void add(const SceneBody& body);
  void substep(double seconds);

  Scene scene_;
  World world_;
  ContactSolver solver_;
  std::deque<MassProperties> masses_;  ///< bodies point at them
  std::vector<RigidBody> bodies_;
  std::vector<std::size_t> woken_;  ///< stays empty: nobody sleeps
  std::vector<BodyId> ids_;
  std::vector<Pose> poses_;
  int steps_ = 0;
  double depth_ = 0, world_seconds_ = 0, solver_seconds_ = 0;
};

}  // namespace graze::samples
