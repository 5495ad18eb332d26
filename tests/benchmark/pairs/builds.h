#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "tests/benchmark/pairs/contestant.h"
#include "tests/benchmark/pairs/scene.h"

namespace graze::benchmark {

/// What it costs a contestant to be ready for a scene's questions.
struct BuildMeasure {
  double milliseconds = 0;                 ///< of both meshes, from their arrays
  std::size_t bytes = 0;                   ///< kept of both, its copies of them included
  std::map<std::string, double> one_shot;  ///< milliseconds of build and one "any", by regime
};

struct BuildSettings {
  int repetitions = 3;  ///< of each tree
  std::size_t threads =
      1;  ///< that it may use: the time is this thread's if it is one, else the wall's
};

/// Medians, each from nothing. Leaves the contestant built. Throws Error if it
/// does not take these meshes.
BuildMeasure measure_build(PairContestant& contestant, const Scene& scene,
                           const BuildSettings& settings);

}  // namespace graze::benchmark
