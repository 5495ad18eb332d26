#pragma once

#include <graze/bvh/pose.h>
#include <Eigen/Core>

namespace graze {

/// A closed oriented box: the points whose coordinates in the frame `pose` lie in
/// [-half_extents, half_extents], metres. Half extents are finite and not negative.
struct Obb {
  Pose pose;                     ///< the place of the box's middle and its axes
  Eigen::Vector3d half_extents;  ///< half the lengths along its own axes, metres

  bool operator==(const Obb& other) const {
    return are_equal(pose, other.pose) && half_extents == other.half_extents;
  }
};

/// Throws InputError or PoseError, which begins with `what`, unless the box is valid.
void check_box(const Obb& box, const char* what);

}  // namespace graze
