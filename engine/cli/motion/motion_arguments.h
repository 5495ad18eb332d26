#pragma once

#include <graze/engine/mesh/rigid_motion.h>

#include <string>
#include <vector>

namespace graze::cli {

/// Says how B moves, as options say it. Those that were not given are empty.
struct MotionArguments {
  std::string from;         ///< B's pose at t = 0, 12 numbers; the identity if it is empty
  std::string to;           ///< B's pose at t = 1
  std::string screw;        ///< point, axis, angle and pitch, 8 numbers
  std::string path;         ///< a file of poses, one a line: a motion from each to the next
  bool is_screwed = false;  ///< true if it moves between poses along and about one line
};

/// Returns the motions that the options name, at least one. Throws UsageError unless exactly one of
/// `to`, `screw` and `path` is given, or with `from` and `path` at once, and PoseError for an
/// invalid pose or screw, and for a file with fewer than two poses.
std::vector<RigidMotion> read_motions(const MotionArguments& arguments);

}  // namespace graze::cli
