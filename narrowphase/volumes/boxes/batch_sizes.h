#pragma once

#include <graze/bvh/error.h>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace graze::narrowphase {

/// Throws InputError unless there is one element of `hits` for each pair.
inline void check_hits(std::span<const std::uint8_t> hits, std::size_t pairs) {
  if (hits.size() == pairs) return;
  throw InputError("hits: " + std::to_string(hits.size()) + " elements for " +
                   std::to_string(pairs) + " pairs");
}

/// Throws InputError, which names the volumes by `what`, unless both lists have one size.
inline void check_pairs(std::size_t size_a, std::size_t size_b, const char* what) {
  if (size_a == size_b) return;
  throw InputError(std::string(what) + " b: " + std::to_string(size_b) + " elements for " +
                   std::to_string(size_a) + " " + what + " a");
}

}  // namespace graze::narrowphase
