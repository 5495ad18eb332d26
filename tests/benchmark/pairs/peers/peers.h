#pragma once

#include <string>
#include <vector>

#include "tests/benchmark/pairs/contestant.h"

namespace graze::benchmark {

/// A library that others made, and its adaptor: a page each in this folder.
struct Peer {
  std::string name;
  void (*add)(PairContestants& contestants);
};

// One of these for each peer that was found.
void add_bullet(PairContestants& contestants);
void add_cgal(PairContestants& contestants);
void add_embree(PairContestants& contestants);
void add_fcl(PairContestants& contestants);
void add_ode(PairContestants& contestants);

/// Those that were found when this was configured.
std::vector<Peer> peers();

/// The names of the others.
std::vector<std::string> absent_peers();

}  // namespace graze::benchmark
