#pragma once

#include <cstddef>
#include <vector>

#include <graze/engine/scenes/scene.h>
#include <graze/engine/world/world.h>

namespace graze {

/// Says how a Simulation goes on.
struct SimulationSettings {
  double step = 0;           ///< seconds; with 0 the scene's own step is taken
  WorldSettings world = {};  ///< the settings of the world that it makes
};

/// Holds a scene in a world, and the clock that moves it. A body's index in the world is its index
/// in the scene.
class Simulation {
 public:
  /// Throws what World::add() throws, and InputError for a step that is negative or not finite, and
  /// for one in which a body that is swept turns by half a turn or more. The scene must outlive
  /// this.
  explicit Simulation(const Scene& scene, const SimulationSettings& settings = {});

  /// Moves the bodies that have paths, and updates the world. The first call brings it to time 0,
  /// each later one a step further. Bodies that are swept go from pose to pose as World::move()
  /// says: a key between two steps is a corner that they cut. Throws PoseError that names body and
  /// time if a path leads beyond what a world can hold. After whatever is thrown the clock stands,
  /// and the next call takes the same step. The spans are valid until the next call.
  WorldUpdate advance();

  /// Return how many steps the last advance() was from time 0, and its time: the product, rounded
  /// once.
  std::size_t steps() const { return count_ == 0 ? 0 : count_ - 1; }
  double time() const { return time_of(steps()); }
  double time_of(std::size_t steps) const { return static_cast<double>(steps) * step_; }

  /// Returns the world that it moves.
  const World& world() const { return world_; }
  /// Returns the world for those who record it. Its bodies are this object's to move.
  World& world() { return world_; }

 private:
  void move_bodies();

  const Scene& scene_;
  double step_;
  World world_;
  std::vector<BodyId> ids_;
  std::size_t count_ = 0;  ///< the number of calls of advance()
};

/// Throws PoseError, naming body and time, if a path leads beyond what a world can hold before
/// `end`, seconds.
void check_paths(const Scene& scene, double end);

}  // namespace graze
