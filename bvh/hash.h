#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace graze {

/// Returns a hash of whole numbers for std::hash of ids and pairs: each goes through the finaliser
/// of SplitMix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number generators", 2014), so
/// that tables of any size may take its low bits. It is the same in every process.
inline std::size_t hash_of(std::initializer_list<std::uint64_t> words) noexcept {
  std::uint64_t hash = 0;
  for (const std::uint64_t word : words) {
    hash += word + 0x9e3779b97f4a7c15u;
    hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
    hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebu;
    hash ^= hash >> 31;
  }
  return static_cast<std::size_t>(hash);
}

}  // namespace graze
