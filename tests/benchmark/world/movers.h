#pragma once

#include "tests/benchmark/world/scene.h"

namespace graze::benchmark {

struct MoverTime {
  std::size_t movers;
  double microseconds;  // of a step, median
};

/// A step of graze in which so many of the bodies move, and the others rest.
std::vector<MoverTime> measure_movers(const Scene& scene, const std::vector<Frame>& path);

}  // namespace graze::benchmark
