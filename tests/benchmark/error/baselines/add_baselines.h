#pragma once

#include "tests/benchmark/error/elements.h"

namespace graze::benchmark {

/// The classic tests in plain double and float, without EPSILON and with several.
void add_baselines(Field& field);

}  // namespace graze::benchmark
