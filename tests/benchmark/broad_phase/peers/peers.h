#pragma once

#include "tests/benchmark/broad_phase/contestant.h"

#include <string>
#include <vector>

namespace graze::benchmark {

// One page each, compiled if the library was found.
void add_bullet(std::vector<Entry>& entries);
void add_cgal(std::vector<Entry>& entries);
void add_embree(std::vector<Entry>& entries);
void add_fcl(std::vector<Entry>& entries);
void add_ode(std::vector<Entry>& entries);

void add_peers(std::vector<Entry>& entries);
std::vector<std::string> absent_peers();

}  // namespace graze::benchmark
