#pragma once

#include <cstddef>

#include "tests/benchmark/error/contest.h"
#include "tests/benchmark/error/elements.h"

namespace graze::benchmark {

/// Oriented boxes, most of them about to touch along a face, an edge or none; the poses are true
/// rotations but for rounding, except in the last category. The truth is that of the boxes
/// {t + R y, |y_i| <= h_i}, in rational arithmetic.
std::size_t obb_category_count();
Category<ObbPair> obb_category(std::size_t index, const Sizes& sizes);

/// The corpora of triangle pairs: a test of two k-DOPs around triangles that meet may not say
/// "apart". An overlap of the k-DOPs of triangles that are apart counts as false, though no test of
/// k-DOPs could know better. Triangles whose k-DOPs overflow are left out: a category may be empty.
std::size_t kdop_category_count();
Category<KDopPair> kdop_category(std::size_t index, const Sizes& sizes);

}  // namespace graze::benchmark
