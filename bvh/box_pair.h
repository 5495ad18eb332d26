#pragma once

#include <compare>
#include <cstdint>

namespace graze {

/// Two boxes by their indices, the smaller first.
struct BoxPair {
  std::uint32_t a;
  std::uint32_t b;
  friend auto operator<=>(const BoxPair&, const BoxPair&) = default;
};

}  // namespace graze
