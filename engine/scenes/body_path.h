#pragma once

#include <variant>
#include <vector>

#include <graze/bvh/pose.h>
#include <Eigen/Core>

namespace graze {

/// Where a body is at a time.
struct PoseKey {
  double time = 0;  ///< seconds
  Pose pose;        ///< where the body is then
};

/// Through poses, one after the other: positions along straight lines, rotations along the shorter
/// arc, both at constant speed. Before the first key and after the last the body rests.
struct KeyPath {
  std::vector<PoseKey> keys;  ///< at least one, times ascending
};

/// From its pose at time 0 on: the frame's origin along a straight line, and the body around it.
struct SteadyPath {
  Eigen::Vector3d velocity{0, 0, 0};  ///< metres a second
  Eigen::Vector3d axis{0, 0, 1};      ///< unit, in the world's frame
  double rate = 0;                    ///< turns a second, counter-clockwise about the axis
};

/// The first: the body stays where it is, or is moved by the program that owns the world.
using BodyPath = std::variant<std::monostate, KeyPath, SteadyPath>;

/// Where a body that starts at `start` is at a time, seconds. At the time of a key its pose, bit
/// for bit; at time 0 of a steady path `start`. The same on every machine: square roots and the
/// four operations, none of them fused. Rotations and positions are off by some ulp, of the
/// coordinates that take part. The result is finite for all that is, unless it overflows.
Pose pose_at(const BodyPath& path, const Pose& start, double time);

}  // namespace graze
