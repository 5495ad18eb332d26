#pragma once

// What the answers about a pair promise, each held against what directions, witness points and the
// swapped question say.

#include <graze/engine/work.h>

#include <cstddef>
#include <string>

#include "tests/engine/special_poses/least_width.h"

namespace graze::tests {

struct PairLawSettings {
  std::size_t directions = 600;  ///< for depths, the more the likelier is the least among them
};

struct PairLawCounts {
  std::size_t pairs = 0;
  std::size_t hits = 0;
  std::size_t depths = 0;       ///< of these, held against the least width
  std::size_t unproved = 0;     ///< depths that the library says it did not prove
  std::size_t unconverged = 0;  ///< distances likewise
  double worst_depth = 0;       ///< more than the least width, in units of what is promised
  double worst_unproved = 0;    ///< more than the least width, as a share of the smaller size
  double worst_distance = 0;    ///< more than a lower bound, likewise
};

/// The first promise that is broken, with numbers; empty if all are kept. Adds to the counts.
std::string broken_law(const PlacedPair& pair, const PairLawSettings& settings,
                       PairLawCounts& counts);

}  // namespace graze::tests
