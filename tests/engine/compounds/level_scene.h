#pragma once

// A level: compounds on a height field, with bodies that move among them.

#include <graze/bvh/pose.h>

#include <cstddef>
#include <cstdint>

#include "tests/engine/compounds/twins.h"

namespace graze::tests {

struct LevelSettings {
  std::uint32_t side;  ///< heights along each side
  double spacing = 1;  ///< metres between them
  Eigen::Vector3d corner = {0, 0, 0};
  int compounds;
  int bodies;
  int steps;
  int questions;  ///< of each kind in each step

  double width() const { return spacing * (side - 1); }
};

/// Metres above the ground.
double height_above(const LevelSettings& level, const Eigen::Vector3d& at);

/// Some metres above the ground, or in it.
Pose somewhere(RandomSource& source, const LevelSettings& level, double lowest, double highest);

/// Body 0 is the ground, then come the compounds, and then the bodies.
void fill_level(Twins& twins, const LevelSettings& level, RandomSource& source);

struct Counts {
  std::size_t contacts = 0, answers = 0;
};

/// Questions of each kind, expected to have the same answers in both worlds.
void ask_some(Twins& twins, const LevelSettings& level, RandomSource& source, Counts& counts);

/// What the environment says, or else the usual; a failure of the test if it is no positive number.
int positive_setting(const char* name, int usual);

}  // namespace graze::tests
