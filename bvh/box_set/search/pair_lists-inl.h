// Appending numbers, and pairs of numbers, by the bits of a mask, without a branch where that pays.
// Included once for each SIMD target.

#if defined(GRAZE_BVH_PAIR_LISTS) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_PAIR_LISTS
#undef GRAZE_BVH_PAIR_LISTS
#else
#define GRAZE_BVH_PAIR_LISTS
#endif

#include <graze/bvh/box_set/search/block_lanes-inl.h>
#include <graze/bvh/box_set/search/pair_buffer.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

// Only the widest registers can be packed in one instruction. Highway 1.0.3 packs others by a table
// that g++ 12.2 copies to the stack each time; there a loop over the bits is faster.
inline constexpr bool kPacks = hn::MaxLanes(Tag()) == kLanes;

/// The lanes whose bits are set, one after the other.
template <typename Numbers>
HWY_INLINE Numbers packed(Numbers numbers, std::uint32_t bits) {
  std::uint8_t bytes[8] = {};  // Highway may read eight bytes
  std::memcpy(bytes, &bits, sizeof(bits));
  return hn::CompressBits(numbers, bytes);
}

/// Stores pairs, side by side. The upper half of a register is hardly ever of use.
template <typename Numbers>
HWY_INLINE void store_pairs(Numbers smaller, Numbers larger, int count, BoxPair* to) {
  const hn::Half<NumberTag> half;
  hn::StoreInterleaved2(hn::LowerHalf(half, smaller), hn::LowerHalf(half, larger), half, &to->a);
  if (HWY_UNLIKELY(count > static_cast<int>(kLanes / 2)))
    hn::StoreInterleaved2(UpperHalf(half, smaller), UpperHalf(half, larger), half,
                          &to[kLanes / 2].a);
}

/// Appends the numbers first + i of the bits i that are set; up to 16 places are written.
template <typename Number>
HWY_INLINE Number* list_bits(std::uint32_t bits, std::uint32_t first, Number* end) {
  if constexpr (kPacks) {
    const NumberTag tag;
    hn::StoreU(packed(hn::Add(hn::Iota(tag, 0), hn::Set(tag, first)), bits), tag, end);
    return end + std::popcount(bits);
  }
  // Four are written whether they are there or not.
  Number* const last = end + std::popcount(bits);
  for (int i = 0; i < 4; ++i, bits &= bits - 1)
    end[i] = first + static_cast<std::uint32_t>(std::countr_zero(bits));
  for (end += 4; HWY_UNLIKELY(bits != 0); bits &= bits - 1)
    *end++ = first + static_cast<std::uint32_t>(std::countr_zero(bits));
  return last;
}

/// Appends the pairs of `mine` with the others whose bits are set; up to 16 places are written.
template <typename Pair>
HWY_INLINE Pair* list_pairs(std::uint32_t mine, const std::uint32_t* others, std::uint32_t bits,
                            Pair* end) {
  if constexpr (kPacks) {
    const NumberTag tag;
    const auto me = hn::Set(tag, mine);
    const auto other = packed(hn::LoadU(tag, others), bits);
    store_pairs(hn::Min(me, other), hn::Max(me, other), std::popcount(bits), end);
    return end + std::popcount(bits);
  }
  // Two are written whether they are there or not.
  Pair* const last = end + std::popcount(bits);
  for (int i = 0; i < 2; ++i, bits &= bits - 1) {
    const std::uint32_t other = others[std::countr_zero(bits | 1u << (kLanes - 1))];
    end[i] = {std::min(mine, other), std::max(mine, other)};
  }
  for (end += 2; HWY_UNLIKELY(bits != 0); bits &= bits - 1) {
    const std::uint32_t other = others[std::countr_zero(bits)];
    *end++ = {std::min(mine, other), std::max(mine, other)};
  }
  return last;
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
