#pragma once

#include <graze/bvh/hash.h>

#include <compare>
#include <cstdint>
#include <functional>

namespace graze {

/// Two boxes by their indices, the smaller first.
struct BoxPair {
  std::uint32_t a;  ///< the smaller index
  std::uint32_t b;  ///< the larger one
  friend auto operator<=>(const BoxPair&, const BoxPair&) = default;
};

}  // namespace graze

template <>
struct std::hash<graze::BoxPair> {
  std::size_t operator()(const graze::BoxPair& pair) const noexcept {
    return graze::hash_of({pair.a, pair.b});
  }
};
