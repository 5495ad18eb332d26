#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace graze::compare {

/// What graze itself said in one pose, step or case.
struct GrazePart {
  std::size_t place = 0;
  std::string digest;  ///< equal for equal answers, bit for bit; empty: it did not answer
  double time = 0;     ///< microseconds
};

/// How a run differs from an older one of the same job.
struct BaselineDifference {
  std::vector<std::size_t> changed;  ///< places where graze's answer has another bit
  std::vector<std::size_t> missing;  ///< one of the two has no answer of graze
  /// How many times as long graze took: the median over what both have, so that neither the first
  /// answer, which builds what others find, nor one slow moment decides.
  double time_ratio = 1;
};

BaselineDifference compare_to_baseline(std::span<const GrazePart> baseline,
                                       std::span<const GrazePart> parts);

}  // namespace graze::compare
