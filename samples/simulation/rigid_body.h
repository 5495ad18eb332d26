#pragma once

#include <graze/engine/world/world.h>
#include <Eigen/Geometry>

#include "samples/simulation/mass_properties.h"

namespace graze::samples {

/// Holds a body as the solver moves it: about its centre of mass. Metres, kilograms, seconds,
/// radians.
struct RigidBody {
  BodyId id;                   ///< the body's id in the world
  const MassProperties* mass;  ///< the mass properties of its mesh
  Eigen::Vector3d at;          ///< the centre of mass, metres
  Eigen::Quaterniond turn;
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();
  double bounding_radius;  ///< the radius about the centre of mass, metres
  double friction = 0.4;  ///< Coulomb's coefficient of its surface; two rub with the geometric mean
  double stillness = 0;   ///< seconds for which it has hardly moved
  bool is_asleep = false;

  /// Returns the pose of the mesh's frame.
  Pose pose() const {
    Pose pose = Pose::Identity();
    pose.linear() = turn.toRotationMatrix();
    pose.translation() = at - pose.linear() * mass->centre;
    return pose;
  }

  double kinetic_energy() const {
    const Eigen::Vector3d local = turn.conjugate() * spin;
    return 0.5 * mass->mass * velocity.squaredNorm() + 0.5 * local.dot(mass->inertia * local);
  }
};

}  // namespace graze::samples
