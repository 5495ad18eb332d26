#pragma once

#include <graze/engine/mesh/rigid_contact.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tests/benchmark/pairs/scene.h"

namespace graze::benchmark {

struct EdgeSettings {
  std::size_t count = 200;  ///< edges in each regime
  double reach = 0.3;       ///< how far B goes along each axis at most: a share of the scene's size
  double turn = 0.3;        ///< radians, at most
  double tolerance = 1e-6;  ///< likewise a share of the size
  std::uint64_t seed = 7;
};

/// What edges of one kind took, microseconds of the processor, each the lesser of two runs.
struct EdgeTimes {
  std::vector<double> first_contact;
  /// Of free edges a hundred static queries along them; of others advancement by distance().
  std::vector<double> other;
};

struct EdgeResult {
  EdgeTimes free;
  EdgeTimes hit;
  std::size_t close = 0;
  std::size_t wrong = 0;  ///< free ones that a sample hits, and times after a hit or without one
};

/// Edges that begin in poses of a regime and lead at random from there.
EdgeResult measure_edges(const Scene& scene, const RegimePoses& regime,
                         const EdgeSettings& settings);

}  // namespace graze::benchmark
