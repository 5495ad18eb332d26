#pragma once

#include "tests/benchmark/world/contestant.h"

#include <string>
#include <vector>

namespace graze::benchmark {

// One page each, compiled if the library was found.
void add_bullet(std::vector<Entry>& entries);
void add_fcl(std::vector<Entry>& entries);

std::vector<Peer> peers();
std::vector<std::string> absent_peers();

}  // namespace graze::benchmark
