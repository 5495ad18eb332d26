#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tests/benchmark/pairs/scene.h"

namespace graze::benchmark {

struct PathSettings {
  std::size_t count = 4;  ///< paths in each regime
  std::size_t steps = 100;
  double step = 0.001;  ///< how far B goes in one, and how far it turns: shares of the scene's size
  double turn = 0.0005;
  std::uint64_t seed = 1;
};

/// A motion of B in A's frame.
using Path = std::vector<Pose>;

/// Paths that begin in poses of the regime and stay in it. B goes straight on, turning about an
/// axis through its middle by an angle that moves its farthest points by `turn`, for as long as it
/// is as far from touching as at the beginning to within a factor of two: without a hit and as
/// near, or with a hit and as many pairs. A step that would leave the regime is replaced by one in
/// another direction; where twenty of these are in vain the path ends.
std::vector<Path> paths_in(const Scene& scene, const RegimePoses& regime,
                           const PathSettings& settings);

}  // namespace graze::benchmark
