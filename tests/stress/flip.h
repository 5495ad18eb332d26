#pragma once

#include "tests/stress/bundled.h"

#include <cstddef>

namespace graze::stress {

/// The two neighbouring doubles of the moved coordinate between which the answer changes.
struct Flip {
  double apart;
  double hit;
};

/// Bisects the motion of a pair to the last double. Throws std::logic_error if the pair begins with
/// a hit, or no hit is found within a hundred steps.
Flip find_flip(const BundledPair& pair);

/// The pose with its moved coordinate at `value`.
Pose pose_at(const BundledPair& pair, double value);

/// What engines answered at `poses` neighbouring doubles around the flip, half of them on either
/// side, and who was wrong by the referee.
struct FlipReport {
  std::size_t poses = 0;
  std::size_t hits = 0;     ///< by the referee
  std::size_t changes = 0;  ///< how often the truth changes from one pose to the next
  std::size_t near = 0;     ///< pairs of triangles that the referee was asked about
  std::size_t graze_wrong = 0;
  std::size_t fcl_wrong = 0;
  bool has_fcl = false;
};
FlipReport report_flip(const BundledPair& pair, const Flip& flip, std::size_t poses);

}  // namespace graze::stress
