#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/world/shape.h>

#include <string>
#include <vector>

#include "samples/simulation/contact_solver.h"

namespace graze::samples {

/// Says what the solver may do with a body of a scene.
enum class Hold {
  Free,   ///< moves as forces make it
  Fixed,  ///< never moves
  Axle,   ///< turns about its own z axis, without friction, and does nothing else
  Motor   ///< turns about its own z axis as fast as it began, whatever resists
};

/// Holds a body of a scene. Metres, seconds, radians, kilograms.
struct SceneBody {
  std::string name;
  Shape shape;
  Pose pose = Pose::Identity();
  Hold hold = Hold::Free;
  double density = 1000;  ///< kg/m^3
  double friction = 0.5;  ///< Coulomb's coefficient of its surface
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();
};

/// Says what must come of a scene.
enum class Outcome {
  Rests,  ///< everything comes to rest
  Moves,  ///< nothing needs to rest, but energy is not made and nothing flies
  Shown   ///< nothing is asked
};

/// Holds bodies over what is fixed, and says how they are to be moved. z is up.
struct Scene {
  std::string name;
  std::vector<SceneBody> bodies;
  Outcome outcome = Outcome::Rests;
  int steps = 600;
  double step = 1.0 / 150;  ///< seconds: contacts are found once in each
  int substeps = 4;  ///< the number of steps in which the solver moves bodies by these contacts
  double gravity = 9.81;  ///< m/s^2
  /// The settings of a substep; its length is said above. Bodies are about half a metre wide.
  SolverSettings solver = {
      .iterations = 6, .relaxations = 2, .slop = 5e-4, .hertz = 60, .keeps_push = true};
};

/// Says whether bodies are shapes of formulas, or the closed meshes of their surfaces.
enum class Surface { Analytic, Mesh };

/// Small scenes take a second or less; large ones have several times the bodies and steps.
enum class Extent { Small, Large };

}  // namespace graze::samples
