#pragma once

#include <cstddef>

#include "tests/benchmark/error/contest.h"
#include "tests/benchmark/error/elements.h"

namespace graze::benchmark {

/// How many categories each question about straight paths has.
std::size_t motion_category_count();

/// Category `index` of points and triangles, and of pairs of edges, that go straight: whether they
/// meet on the way. The truth about all of them is found in rational arithmetic.
Category<MotionQuery> moving_point_category(std::size_t index, const Sizes& sizes);
Category<MotionQuery> moving_edge_category(std::size_t index, const Sizes& sizes);

}  // namespace graze::benchmark
