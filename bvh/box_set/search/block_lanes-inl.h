// The boxes of a block lane by lane against one box: which may overlap it, which surely do.
// Included once for each SIMD target.

#if defined(GRAZE_BVH_BLOCK_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_BLOCK_LANES
#undef GRAZE_BVH_BLOCK_LANES
#else
#define GRAZE_BVH_BLOCK_LANES
#endif

#include <graze/bvh/box_set/store/block.h>
#include <hwy/highway.h>

#include <bit>
#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<std::int32_t, kLanes>;
using NumberTag = hn::RebindToUnsigned<Tag>;
using Lanes = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;

// A register that is not the widest holds part of a block; bits of its lanes are the lowest ones.
inline constexpr std::uint32_t kAllHere = (1u << hn::MaxLanes(Tag())) - 1;
static_assert(std::endian::native == std::endian::little);

HWY_INLINE std::uint32_t bits_of(Mask mask) {
  std::uint8_t bytes[8] = {};  // Highway may write eight bytes
  hn::StoreMaskBits(Tag(), mask, bytes);
  if constexpr (hn::MaxLanes(Tag()) <= 8) return bytes[0];  // two bytes would wait for two stores
  std::uint16_t bits;
  std::memcpy(&bits, bytes, sizeof(bits));
  return bits;
}

/// One box, each of its high halves in all lanes of a register.
struct BroadcastBox {
  Lanes row[6];
  HWY_INLINE BroadcastBox(const Block& block, std::uint32_t lane) {
    for (int c = 0; c < 6; ++c)
      row[c] = hn::Set(Tag(), block.row[c][lane]);
  }
  HWY_INLINE explicit BroadcastBox(const OrderedBox& box) {
    for (std::size_t c = 0; c < 6; ++c)
      row[c] = hn::Set(Tag(), high_half(box[c]));
  }
};

/// Bit i is set unless the high halves alone show that lane i and the box share no point.
HWY_INLINE std::uint32_t near_lanes(const Block& block, const BroadcastBox& box) {
  const Tag tag;
  std::uint32_t far_bits = 0;
  for (std::uint32_t lane = 0; lane < kLanes; lane += static_cast<std::uint32_t>(hn::Lanes(tag))) {
    Mask is_far = hn::Gt(hn::Load(tag, block.row[0] + lane), box.row[3]);
    for (int c = 1; c < 3; ++c)
      is_far = hn::Or(is_far, hn::Gt(hn::Load(tag, block.row[c] + lane), box.row[c + 3]));
    for (int c = 0; c < 3; ++c)
      is_far = hn::Or(is_far, hn::Gt(box.row[c], hn::Load(tag, block.row[c + 3] + lane)));
    far_bits |= bits_of(is_far) << lane;
  }
  return ~far_bits & 0xffff;
}

/// Bit i is set if the high halves alone show that lane i and the box overlap.
HWY_INLINE std::uint32_t sure_lanes(const Block& block, const BroadcastBox& box) {
  const Tag tag;
  std::uint32_t bits = 0;
  for (std::uint32_t lane = 0; lane < kLanes; lane += static_cast<std::uint32_t>(hn::Lanes(tag))) {
    Mask is_sure = hn::Lt(hn::Load(tag, block.row[0] + lane), box.row[3]);
    for (int c = 1; c < 3; ++c)
      is_sure = hn::And(is_sure, hn::Lt(hn::Load(tag, block.row[c] + lane), box.row[c + 3]));
    for (int c = 0; c < 3; ++c)
      is_sure = hn::And(is_sure, hn::Lt(box.row[c], hn::Load(tag, block.row[c + 3] + lane)));
    bits |= bits_of(is_sure) << lane;
  }
  return bits;
}

/// The bits of those `unsure` lanes that overlap the box by the low halves, too.
inline HWY_NOINLINE std::uint32_t decided_lanes(const Block& high, const LowBlock& low,
                                                const OrderedBox& box, std::uint32_t unsure) {
  std::uint32_t bits = 0;
  for (; unsure != 0; unsure &= unsure - 1) {
    const auto lane = static_cast<std::uint32_t>(std::countr_zero(unsure));
    if (overlap(lane_box(high, low, lane), box)) bits |= 1u << lane;
  }
  return bits;
}

HWY_INLINE BroadcastBox bounds(const TreeView& tree, int level, std::uint32_t block) {
  return BroadcastBox(tree.level[level + 1][block >> kLaneBits], block & (kLanes - 1));
}

/// Lanes of a block by what the high halves of a box say about them.
struct NearLanes {
  std::uint32_t near;    ///< not shown to be apart from the box
  std::uint32_t unsure;  ///< of these: high halves are equal, so that the low ones decide
};

/// As near_lanes() and sure_lanes(), by the interval that the two have in common along each axis.
/// Where its length is 0, high halves are equal, and the low ones decide.
HWY_INLINE NearLanes near_and_unsure(const Block& block, const BroadcastBox& box) {
  const Tag tag;
  const hn::RebindToUnsigned<Tag> lengths;
  NearLanes sum = {0, 0};
  for (std::uint32_t lane = 0; lane < kLanes; lane += static_cast<std::uint32_t>(hn::Lanes(tag))) {
    Lanes low = hn::Max(hn::Load(tag, block.row[0] + lane), box.row[0]);
    Lanes high = hn::Min(hn::Load(tag, block.row[3] + lane), box.row[3]);
    Mask is_far = hn::Gt(low, high);
    auto least = hn::BitCast(lengths, hn::Sub(high, low));
    for (int c = 1; c < 3; ++c) {
      low = hn::Max(hn::Load(tag, block.row[c] + lane), box.row[c]);
      high = hn::Min(hn::Load(tag, block.row[c + 3] + lane), box.row[c + 3]);
      is_far = hn::Or(is_far, hn::Gt(low, high));
      least = hn::Min(least, hn::BitCast(lengths, hn::Sub(high, low)));
    }
    const Mask is_equal = hn::Eq(hn::BitCast(tag, least), hn::Zero(tag));
    const std::uint32_t near = ~bits_of(is_far) & kAllHere;
    sum.near |= near << lane;
    sum.unsure |= (near & bits_of(is_equal)) << lane;
  }
  return sum;
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
