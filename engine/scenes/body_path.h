#pragma once

#include <variant>
#include <vector>

#include <graze/bvh/pose.h>
#include <Eigen/Core>

namespace graze {

/// Says where a body is at a time.
struct PoseKey {
  double time = 0;  ///< seconds
  Pose pose;        ///< the body's pose at that time
};

/// A path through poses, one after the other: positions along straight lines, rotations along the
/// shorter arc, both at constant speed. Before the first key and after the last the body rests.
struct KeyPath {
  std::vector<PoseKey> keys;  ///< the keys, at least one, times ascending
};

/// A path from the body's pose at time 0 on: the frame's origin goes along a straight line, and the
/// body turns around it.
struct SteadyPath {
  Eigen::Vector3d velocity{0, 0, 0};  ///< metres a second
  Eigen::Vector3d axis{0, 0, 1};      ///< the unit axis, in the world's frame
  double rate = 0;                    ///< turns a second, counter-clockwise about the axis
};

/// A path. With the first kind the body stays where it is, or is moved by the program that owns the
/// world.
using BodyPath = std::variant<std::monostate, KeyPath, SteadyPath>;

/// Returns where a body that starts at `start` is at a time, seconds. At the time of a key that is
/// its pose, bit for bit; at time 0 of a steady path it is `start`. The result is the same on every
/// machine: it takes square roots and the four operations, none of them fused. Rotations and
/// positions are off by some ulp, of the coordinates that take part. The result is finite for
/// finite input, unless it overflows.
Pose pose_at(const BodyPath& path, const Pose& start, double time);

}  // namespace graze
