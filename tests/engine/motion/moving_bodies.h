#pragma once

// Bodies that take random ways, for worlds that sweep them.

#include <graze/engine/world/shape_motion.h>
#include <graze/engine/world/world.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/random_source.h"

namespace graze::tests {

inline Shape random_small_shape(RandomSource& source, int kind) {
  const double size = source.uniform(0.1, 0.6);
  switch (kind % 6) {
    case 0:
      return Sphere{{0, 0, 0}, size};
    case 1:
      return Box{{size, 0.5 * size, 0.02}};
    case 2:
      return Capsule{0.2 * size, size};
    case 3:
      return Cone{size, size};
    case 4:
      return Ellipsoid{{0, 0, 0}, {size, 0.1, 0.3}};
    default:
      return make_box({size, 0.3, 0.1});
  }
}

inline Pose random_pose(RandomSource& source, double reach) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd{source.uniform(-3, 3), source.vector(-1, 1).normalized()}
                      .toRotationMatrix();
  pose.translation() = source.vector(-reach, reach);
  return pose;
}

/// Moved and turned by as much.
inline Pose moved(RandomSource& source, const Pose& pose, double way, double angle) {
  Pose next = pose;
  next.linear() =
      (Eigen::AngleAxisd{source.uniform(-angle, angle), source.vector(-1, 1).normalized()} *
       Eigen::Quaterniond(pose.linear()).normalized())
          .toRotationMatrix();
  next.translation() += source.vector(-way, way);
  return next;
}

/// A body as a test knows it.
struct KnownBody {
  BodyId id;
  Shape shape;
  Pose before, now;
  Detection detection;
  bool has_moved = false;

  RigidMotion motion() const { return RigidMotion::between(before, now); }
};

/// All first contacts, every pair asked alone; of bodies in ascending order of their ids.
inline std::vector<BodyFirstContact> ask_every_pair(const std::vector<KnownBody>& bodies,
                                                    const RigidContactSettings& settings) {
  const auto is_swept = [](const KnownBody& body) {
    return body.has_moved && body.detection == Detection::Continuous;
  };
  std::vector<BodyFirstContact> found;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      const KnownBody &a = bodies[i], &b = bodies[j];
      if (!is_swept(a) && !is_swept(b)) continue;
      const RigidContact contact =
          first_contact({a.shape, a.motion()}, {b.shape, b.motion()}, settings);
      if (contact.status == RigidStatus::Free) continue;
      found.push_back({.pair = {a.id, b.id},
                       .contact = contact,
                       .is_at_start = intersects({a.shape, a.before}, {b.shape, b.before}),
                       .normal = Eigen::Vector3d::Zero(),
                       .point = Eigen::Vector3d::Zero()});
    }
  }
  return found;
}

}  // namespace graze::tests
