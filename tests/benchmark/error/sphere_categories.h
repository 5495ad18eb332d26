#pragma once

#include <cstddef>

#include "tests/benchmark/error/contest.h"
#include "tests/benchmark/error/elements.h"

namespace graze::benchmark {

/// How many categories each question about spheres has.
std::size_t sphere_category_count();

/// Category `index` of the same kinds of input for both questions. The truth about all of them is
/// found in rational arithmetic.
Category<SphereAndBox> sphere_box_category(std::size_t index, const Sizes& sizes);
Category<SpherePair> sphere_pair_category(std::size_t index, const Sizes& sizes);

}  // namespace graze::benchmark
