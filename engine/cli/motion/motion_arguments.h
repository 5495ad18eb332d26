#pragma once

#include <graze/engine/mesh/rigid_motion.h>

#include <string>
#include <vector>

namespace graze::cli {

/// How B moves, as options say it. Empty: not given.
struct MotionArguments {
  std::string from;         ///< its pose at t = 0, 12 numbers; else the identity
  std::string to;           ///< its pose at t = 1
  std::string screw;        ///< point, axis, angle and pitch, 8 numbers
  std::string path;         ///< a file of poses, one a line: a motion from each to the next
  bool is_screwed = false;  ///< between poses it moves along and about one line
};

/// The motions that they name, at least one. Throws UsageError unless exactly one of `to`, `screw`
/// and `path` is given, or with `from` and `path` at once, and PoseError for what is no pose, no
/// screw and no file of two poses or more.
std::vector<RigidMotion> read_motions(const MotionArguments& arguments);

}  // namespace graze::cli
