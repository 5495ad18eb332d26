#pragma once

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision_object.h>

#include <memory>

#include "tests/benchmark/compounds/contestant.h"

namespace graze::benchmark {

inline fcl::Transform3d to_fcl(const Pose& pose) {
  fcl::Transform3d transform;
  transform.matrix() = pose.matrix();
  return transform;
}

/// A box, a ball or a capsule.
inline std::shared_ptr<fcl::CollisionGeometryd> to_fcl(const Shape& shape) {
  if (const auto* ball = shape.as<Sphere>()) return std::make_shared<fcl::Sphered>(ball->radius);
  if (const auto* capsule = shape.as<Capsule>())
    return std::make_shared<fcl::Capsuled>(capsule->radius, 2 * capsule->half_length);
  const Eigen::Vector3d side = 2 * shape.as<Box>()->half_extents;
  return std::make_shared<fcl::Boxd>(side.x(), side.y(), side.z());
}

}  // namespace graze::benchmark
