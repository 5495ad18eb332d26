#pragma once

#include "tests/benchmark/world/scene.h"

namespace graze::benchmark {

struct MoverTime {
  std::size_t movers;
  double microseconds;  // of a step, median
};

/// A step of graze in which so many of the bodies move, and the others rest.
std::vector<MoverTime> measure_movers(const Scene& scene, const std::vector<Frame>& path);

struct CrowdTime {
  std::size_t movers;
  double microseconds;  // of a step, median
  double tested;        // pairs of shapes in a step, mean
};

/// Steps of graze in a crowd of so many boxes and balls that each touches one or two others; in
/// each step others move, chosen at random, of any number of `movers` that does not exceed them.
std::vector<CrowdTime> measure_crowd(std::size_t bodies, const std::vector<std::size_t>& movers,
                                     std::size_t steps);

}  // namespace graze::benchmark
