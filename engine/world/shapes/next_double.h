#pragma once

// Returns the doubles beside a double, as std::nextafter() towards the infinities does, without the
// call. Private to engine/world; static, so that each source compiles its own copy, whatever flags
// others have.

#include <bit>
#include <cstdint>
#include <limits>

namespace graze {

/// Returns the least double above a value. Infinity and NaN are returned unchanged.
static inline double next_up(double value) {
  if (!(value < std::numeric_limits<double>::infinity())) return value;
  if (value == 0) return std::numeric_limits<double>::denorm_min();
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return std::bit_cast<double>(value > 0 ? bits + 1 : bits - 1);
}

static inline double next_down(double value) {
  return -next_up(-value);
}

}  // namespace graze
