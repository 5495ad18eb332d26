#pragma once

#include "tests/benchmark/broad_phase/contestant.h"

namespace graze::benchmark {

std::unique_ptr<Contestant> make_graze(int threads);

}  // namespace graze::benchmark
