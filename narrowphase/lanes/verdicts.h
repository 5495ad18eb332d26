#pragma once

#include <graze/narrowphase/predicates/verdict.h>

#include <cstdint>

namespace graze::narrowphase {

/// Returns the verdict of two proofs, of which at most one holds. It has no branch, because a CPU
/// often cannot predict which of them does.
constexpr Verdict verdict_of(bool is_apart, bool is_touching) {
  static_assert(static_cast<int>(Verdict::No) == 0 && static_cast<int>(Verdict::Yes) == 1 &&
                static_cast<int>(Verdict::Unsure) == 2);
  return static_cast<Verdict>((2 - static_cast<int>(is_touching)) &
                              (static_cast<int>(is_apart) - 1));
}

/// Holds the verdicts of several pairs: bit i is set in one of these, or in neither if pair i is
/// unsure.
struct Verdicts {
  std::uint32_t apart = 0;
  std::uint32_t touching = 0;
};

}  // namespace graze::narrowphase
