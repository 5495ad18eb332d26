#pragma once

#include "tests/benchmark/broad_phase/contestant.h"

#include <cstdint>
#include <string>
#include <vector>

namespace graze::benchmark {

struct Course {
  std::string scene;
  std::uint32_t boxes;
  int frames;
  double patience;  // milliseconds: after a slower frame the course is cut short
  double budget;    // milliseconds: and after so much in all, but not before a few frames
};

struct Score {
  std::string scene, contestant;
  std::uint32_t boxes = 0;
  int frames = 0;
  double median = 0, mean = 0,
         slowest = 0;        // milliseconds: of one processor, or of a clock for more threads
  std::size_t pairs = 0;     // in the last frame
  double start = 0;          // milliseconds to take all boxes
  double bytes_per_box = 0;  // beside the pairs, at the end
  int wrong_frames = 0;      // in which the pairs are not those of the first contestant
};

/// A number for the set of pairs of each frame, whatever their order.
using Truth = std::vector<std::uint64_t>;

/// The first contestant to run sets the truth. Contestants run one after the other, each through
/// the same scene, so that none finds another's data in the cache.
Score measure(const Entry& entry, const Course& course, Truth& truth);

/// Microseconds of an update of graze with `count` movers among `boxes`, median.
double measure_movers(std::uint32_t boxes, std::uint32_t count, int frames);

}  // namespace graze::benchmark
