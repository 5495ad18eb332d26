#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include <graze/narrowphase/triangle_pair/triangle_pair_batch.h>

namespace graze::benchmark {

inline constexpr std::size_t kBlock = narrowphase::kVerdictsBlock;

/// The bits of a byte as eight bytes, 1 or 0, the first bit first on little-endian machines.
inline std::uint64_t spread(std::uint32_t bits) {
  const std::uint64_t each = bits * 0x0101010101010101 & 0x8040201008040201;
  return ((each + 0x7f7f7f7f7f7f7f7f) | each) >> 7 & 0x0101010101010101;
}

/// Turns the verdicts of blocks of eight into answers; `is_hit(element)` decides what is unsure.
template <typename Element, typename IsHit>
void finish(const narrowphase::Verdicts* blocks, const Element* elements, std::size_t count,
            std::uint8_t* hits, IsHit is_hit) {
  for (std::size_t first = 0; first < count; first += kBlock) {
    const narrowphase::Verdicts block = *blocks++;
    const std::size_t size = std::min(kBlock, count - first);
    const std::uint64_t bytes = spread(block.touching);
    if (size == kBlock) {
      std::memcpy(hits + first, &bytes, kBlock);
    } else {
      std::memcpy(hits + first, &bytes, size);
    }
    const std::uint32_t used = (std::uint32_t{1} << size) - 1;
    for (std::uint32_t left = ~(block.apart | block.touching) & used; left != 0; left &= left - 1) {
      const std::size_t n = first + static_cast<std::size_t>(std::countr_zero(left));
      hits[n] = is_hit(elements[n]);
    }
  }
}

}  // namespace graze::benchmark
