#pragma once

#include <cstddef>

#include "tests/benchmark/error/contest.h"
#include "tests/benchmark/error/elements.h"

namespace graze::benchmark {

/// How many categories each question has.
std::size_t pair_category_count();
std::size_t box_category_count();

/// Category `index` of the corpora of hard inputs. The truth comes from the library's exact stage,
/// and every so often from the referee. Throws Error, with the case, where these differ.
Category<TrianglePair> pair_category(std::size_t index, const Sizes& sizes);
Category<TriangleAndBox> box_category(std::size_t index, const Sizes& sizes);

}  // namespace graze::benchmark
