#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tests/benchmark/error/contest.h"
#include "tests/benchmark/error/elements.h"

namespace graze::benchmark {

/// Distinct pairs with the true distance of each, and the ulp that its error is measured in: of the
/// largest absolute coordinate.
struct DistanceCategory {
  std::string name;
  bool is_generic;  ///< general position, ordinary size
  std::vector<TrianglePair> elements;
  std::vector<double> truth;
  std::vector<double> ulp;
};

std::size_t distance_category_count();

/// Category `index`: pairs that are apart in ways of their own, then the corpora of hard pairs, of
/// which most touch or nearly do. All truth is rational.
DistanceCategory distance_category(std::size_t index, const Sizes& sizes);

}  // namespace graze::benchmark
