#pragma once

#include <functional>
#include <memory>
#include <string>

#include "tests/benchmark/world/scene.h"

namespace graze::benchmark {

struct Counts {
  std::size_t pairs = 0;     // that touch
  std::size_t contacts = 0;  // of those, in the hands of who asked
};

/// Shares of contacts; negative if they are not known.
struct Lasting {
  double by_features = -1;  // that have the features of one of the step before
  double by_tracker = -1;   // that go on as ContactTracker says
  double tracker_ms = 0;    // what it takes to know that
};

/// A world under measurement: poses in, contacts of all pairs that touch out, frame by frame.
class Contestant {
 public:
  virtual ~Contestant() = default;
  virtual void start(const Scene& scene, const Frame& frame) = 0;

  /// What is timed: every body is where the frame says.
  virtual Counts step(const Frame& frame) = 0;

  /// What share of contacts goes on from the step before, of the pairs that touched then; not
  /// timed.
  virtual Lasting lasting() { return {}; }
};

struct Peer {
  std::string name;
  std::function<void(std::vector<struct Entry>&)> add;
};

struct Entry {
  std::string name;
  std::function<std::unique_ptr<Contestant>()> make;
};

std::unique_ptr<Contestant> make_graze();

}  // namespace graze::benchmark
