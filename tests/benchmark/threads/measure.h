#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tests/benchmark/pairs/scene.h"

namespace graze::benchmark {

/// What is shared by threads.
enum class Sharing {
  AnyOfPoses,    ///< for a batch of poses, yes or no
  PairsOfPoses,  ///< for a batch of poses, all pairs
  OneQuery,      ///< all pairs in one pose, pose after pose
};
inline constexpr Sharing kSharings[] = {Sharing::AnyOfPoses, Sharing::PairsOfPoses,
                                        Sharing::OneQuery};

const char* name_of(Sharing sharing);

struct ThreadTimes {
  std::vector<double> microseconds;  ///< a query, for each number of threads: of the median round
  std::size_t pairs = 0;             ///< of triangles, in all poses
  std::size_t wrong = 0;             ///< answers that differ from those of one thread
};

/// Each round asks in all poses with each number of threads in turn.
ThreadTimes measure_threads(const Scene& scene, const RegimePoses& regime, Sharing sharing,
                            const std::vector<int>& threads, int rounds);

}  // namespace graze::benchmark
