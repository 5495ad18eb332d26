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
  std::size_t surfaces = 0;     ///< pairs with a mesh
  std::size_t unproved = 0;     ///< depths that the library says it did not prove
  std::size_t unconverged = 0;  ///< distances likewise
  double worst_depth = 0;       ///< more than the least width, in units of what is promised
  double worst_unproved = 0;    ///< more than the least width, as a share of the smaller size
  double worst_distance = 0;    ///< more than a lower bound, likewise
  double worst_point = 0;       ///< of a contact off its surface, in units of what is promised
  double worst_mesh_point = 0;  ///< of contacts of two meshes, likewise
  double worst_open = 0;  ///< of what a search left open: how far bounds, or the points of a hit,
                          ///< are apart, as a share of the scale. Nothing is promised of that
};

/// The first promise that is broken, with numbers; empty if all are kept. Adds to the counts.
/// Of any two but half-spaces; a mesh must be one of a box, by make_box(), or one that the other is
/// not inside of.
std::string broken_law(const PlacedPair& pair, const PairLawSettings& settings,
                       PairLawCounts& counts);

/// Likewise, if the answers about the pair, all its lengths times a power of two, are others than
/// that many times those about the pair itself, beyond what is promised.
std::string broken_scaling(const PlacedPair& pair, double factor);

}  // namespace graze::tests
