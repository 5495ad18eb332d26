// Compiles find_overlaps() for each SIMD target that the compiler knows; the widest that the CPU
// has is chosen when the program runs. It only compares, so nothing is rounded.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/narrowphase/volumes/boxes/kdop_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/narrowphase/volumes/boxes/kdop_kernels.h>
#include <hwy/highway.h>
#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <tuple>

HWY_BEFORE_NAMESPACE();
namespace graze::narrowphase::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
constexpr std::size_t kAtOnce = VolumeRows<6>::kAtOnce;
using Tag = hn::CappedTag<double, kAtOnce>;
using Lanes = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;

HWY_INLINE Lanes load(double value, std::size_t) {
  return hn::Set(Tag(), value);
}

HWY_INLINE Lanes load(const double* row, std::size_t first) {
  return hn::LoadU(Tag(), row + first);
}

template <typename A, typename B>
HWY_INLINE std::uint64_t overlapping(const A& a, const B& b, std::size_t first) {
  constexpr std::size_t kSlabs = std::tuple_size_v<B> / 2;
  Mask mask = hn::And(hn::Le(load(a[0], first), load(b[kSlabs], first)),
                      hn::Le(load(b[0], first), load(a[kSlabs], first)));
  for (std::size_t i = 1; i < kSlabs; ++i) {
    mask = hn::And(mask, hn::Le(load(a[i], first), load(b[kSlabs + i], first)));
    mask = hn::And(mask, hn::Le(load(b[i], first), load(a[kSlabs + i], first)));
  }
  std::uint8_t bits[8] = {};  // Highway may write eight bytes
  hn::StoreMaskBits(Tag(), mask, bits);
  return bits[0];
}

/// Makes bit i of eight the lowest bit of byte i: seven by a product in which no two meet.
HWY_INLINE std::uint64_t byte_for_each(std::uint64_t bits) {
  const std::uint64_t low = ((bits & 0x7f) * 0x0002040810204081u) & 0x0001010101010101u;
  return low | (bits >> 7) << 56;
}

template <typename A, typename B>
HWY_INLINE void find(const A& a, const B& b, std::size_t count, std::uint8_t* hits) {
  for (std::size_t first = 0; first < count; first += kAtOnce) {
    std::uint64_t bits = 0;
    for (std::size_t lane = 0; lane < kAtOnce; lane += hn::Lanes(Tag()))
      bits |= overlapping(a, b, first + lane) << lane;
    const std::uint64_t bytes = byte_for_each(bits);
    if (first + kAtOnce <= count) {
      for (std::size_t i = 0; i < kAtOnce; ++i)
        hits[first + i] = static_cast<std::uint8_t>(bytes >> (8 * i));
    } else {
      for (std::size_t i = first; i < count; ++i)
        hits[i] = static_cast<std::uint8_t>(bytes >> (8 * (i - first)));
    }
  }
}

void one_box(const std::array<double, 6>& one, const RowPointers<6>& many, std::size_t count,
             std::uint8_t* hits) {
  find(one, many, count, hits);
}

void box_pairs(const RowPointers<6>& a, const RowPointers<6>& b, std::size_t count,
               std::uint8_t* hits) {
  find(a, b, count, hits);
}

void one_kdop(const std::array<double, 18>& one, const RowPointers<18>& many, std::size_t count,
              std::uint8_t* hits) {
  find(one, many, count, hits);
}

void kdop_pairs(const RowPointers<18>& a, const RowPointers<18>& b, std::size_t count,
                std::uint8_t* hits) {
  find(a, b, count, hits);
}

using WholeTag = hn::CappedTag<std::int64_t, 8>;
using Whole = hn::Vec<WholeTag>;

// The bits of doubles are taken as whole numbers in the order of the doubles, both zeros as 0: a
// double has a sign and a size, which take the complement that whole numbers have. What is no
// number lies beyond the infinity of its sign. Comparing these asks nothing of the control word,
// reads denormal numbers whatever it says, and raises no exception.

constexpr std::int64_t kSizeBits = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kLargestFinite = 0x7fefffffffffffff;

HWY_INLINE Whole in_order(Whole bits) {
  const Whole sign = hn::BroadcastSignBit(bits);
  return hn::Sub(hn::Xor(hn::And(bits, hn::Set(WholeTag(), kSizeBits)), sign), sign);
}

HWY_INLINE std::int64_t in_order(double value) {
  const auto bits = std::bit_cast<std::int64_t>(value);
  const std::int64_t sign = bits >> 63;
  return ((bits & kSizeBits) ^ sign) - sign;
}

HWY_INLINE Whole load_in_order(const double* from) {
  return in_order(hn::LoadU(WholeTag(), reinterpret_cast<const std::int64_t*>(from)));
}

KDopPairAnswer one_pair(const KDop<18>& a, const KDop<18>& b) {
  constexpr std::size_t kSlabsInVectors = 8;  // the ninth is looked at by itself
  static_assert(KDop<18>::kSlabs == kSlabsInVectors + 1);
  const WholeTag tag;
  Whole least = hn::Zero(tag), most = least;
  auto is_invalid = hn::Lt(least, most), is_apart = is_invalid;
  for (std::size_t first = 0; first < kSlabsInVectors; first += hn::Lanes(tag)) {
    const Whole min_a = load_in_order(&a.min[first]), max_a = load_in_order(&a.max[first]);
    const Whole min_b = load_in_order(&b.min[first]), max_b = load_in_order(&b.max[first]);
    is_invalid = hn::Or(is_invalid, hn::Or(hn::Gt(min_a, max_a), hn::Gt(min_b, max_b)));
    is_apart = hn::Or(is_apart, hn::Gt(hn::Max(min_a, min_b), hn::Min(max_a, max_b)));
    least = hn::Min(least, hn::Min(min_a, min_b));
    most = hn::Max(most, hn::Max(max_a, max_b));
  }
  is_invalid = hn::Or(is_invalid, hn::Or(hn::Lt(least, hn::Set(tag, -kLargestFinite)),
                                         hn::Gt(most, hn::Set(tag, kLargestFinite))));
  const std::int64_t min_a = in_order(a.min.back()), max_a = in_order(a.max.back());
  const std::int64_t min_b = in_order(b.min.back()), max_b = in_order(b.max.back());
  if (!hn::AllFalse(tag, is_invalid) || min_a > max_a || min_b > max_b ||
      std::min(min_a, min_b) < -kLargestFinite || std::max(max_a, max_b) > kLargestFinite)
      [[unlikely]]
    return KDopPairAnswer::Invalid;
  // This has no branch: where two k-DOPs lie is as good as drawn by lot.
  const bool are_apart = !hn::AllFalse(tag, is_apart) | (min_a > max_b) | (min_b > max_a);
  return are_apart ? KDopPairAnswer::Apart : KDopPairAnswer::MayOverlap;
}

}  // namespace
}  // namespace graze::narrowphase::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::narrowphase {

HWY_EXPORT(one_box);
HWY_EXPORT(box_pairs);
HWY_EXPORT(one_kdop);
HWY_EXPORT(kdop_pairs);
HWY_EXPORT(one_pair);

void find_overlaps(const std::array<double, 6>& one, const RowPointers<6>& many, std::size_t count,
                   std::uint8_t* hits) {
  HWY_DYNAMIC_DISPATCH(one_box)(one, many, count, hits);
}

void find_overlaps(const RowPointers<6>& a, const RowPointers<6>& b, std::size_t count,
                   std::uint8_t* hits) {
  HWY_DYNAMIC_DISPATCH(box_pairs)(a, b, count, hits);
}

void find_overlaps(const std::array<double, 18>& one, const RowPointers<18>& many,
                   std::size_t count, std::uint8_t* hits) {
  HWY_DYNAMIC_DISPATCH(one_kdop)(one, many, count, hits);
}

void find_overlaps(const RowPointers<18>& a, const RowPointers<18>& b, std::size_t count,
                   std::uint8_t* hits) {
  HWY_DYNAMIC_DISPATCH(kdop_pairs)(a, b, count, hits);
}

KDopPairAnswer look_at_pair(const KDop<18>& a, const KDop<18>& b) {
  return HWY_DYNAMIC_DISPATCH(one_pair)(a, b);
}

}  // namespace graze::narrowphase
#endif
