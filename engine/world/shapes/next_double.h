#pragma once

// The doubles beside one: std::nextafter() towards the infinities, without the call. Private to
// engine/world; static, so that each source compiles its own copy, whatever flags others have.

#include <bit>
#include <cstdint>
#include <limits>

namespace graze {

/// The least double above; infinity and what is no number stay what they are.
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
