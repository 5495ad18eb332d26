#pragma once

// Doubles as integers of the same order, in two halves: comparing the high halves of two numbers
// decides all but the pairs whose high halves are equal, without any rounding.

#include <graze/bvh/aabb.h>

#include <array>
#include <bit>
#include <cstdint>

namespace graze::bvh {

// These are static so that each source compiles its own: an inline function is shared by the
// linker, and the copy that it keeps could be one compiled with a user's -ffast-math.

/// An integer for each finite double: a < b exactly if ordered_key(a) < ordered_key(b). Both zeros
/// have the key 0. Integers throughout, so that no compiler flag can fold the zeros back apart.
static inline std::int64_t ordered_key(double value) {
  const std::int64_t bits = std::bit_cast<std::int64_t>(value);
  const std::int64_t sign = bits >> 63;
  // Of a negative number the magnitude counts downwards: -(magnitude), which sends -0 to 0.
  return ((bits & INT64_MAX) ^ sign) - sign;
}

/// The double whose key this is.
static inline double value_of_key(std::int64_t key) {
  const std::int64_t sign = key >> 63;
  return std::bit_cast<double>(((key ^ sign) - sign) | (sign & INT64_MIN));
}

static inline std::int32_t high_half(std::int64_t key) {
  return static_cast<std::int32_t>(key >> 32);
}

static inline std::uint32_t low_half(std::int64_t key) {
  return static_cast<std::uint32_t>(key);
}

static inline std::int64_t joined(std::int32_t high, std::uint32_t low) {
  return static_cast<std::int64_t>(
      static_cast<std::uint64_t>(static_cast<std::uint32_t>(high)) << 32 | low);
}

/// The keys of min x, y, z, max x, y, z.
using OrderedBox = std::array<std::int64_t, 6>;

static inline OrderedBox ordered_box(const Aabb& box) {
  OrderedBox keys;
  for (std::size_t c = 0; c < 3; ++c) {
    keys[c] = ordered_key(box.min.data()[c]);
    keys[c + 3] = ordered_key(box.max.data()[c]);
  }
  return keys;
}

static inline Aabb box_of_keys(const OrderedBox& keys) {
  Aabb box;
  for (std::size_t c = 0; c < 3; ++c) {
    box.min.data()[c] = value_of_key(keys[c]);
    box.max.data()[c] = value_of_key(keys[c + 3]);
  }
  return box;
}

/// What overlaps nothing.
static inline OrderedBox no_box() {
  return {INT64_MAX, INT64_MAX, INT64_MAX, INT64_MIN, INT64_MIN, INT64_MIN};
}

/// True exactly when the closed boxes share a point.
static inline bool overlap(const OrderedBox& a, const OrderedBox& b) {
  bool is_overlapping = true;
  for (std::size_t c = 0; c < 3; ++c)
    is_overlapping &= a[c] <= b[c + 3] && b[c] <= a[c + 3];
  return is_overlapping;
}

}  // namespace graze::bvh
