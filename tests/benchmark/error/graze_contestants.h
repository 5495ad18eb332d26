#pragma once

#include "tests/benchmark/error/elements.h"

namespace graze::benchmark {

/// The library itself: as users call it, its rounded stage alone, and in batches.
void add_graze(Field& field);

}  // namespace graze::benchmark
