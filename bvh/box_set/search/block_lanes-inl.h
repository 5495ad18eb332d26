// These compare the boxes of a block with one box, lane by lane: which may overlap it, and which
// surely do; and blocks with blocks, many pairs of them at a time. This file is included once for
// each SIMD target.

#if defined(GRAZE_BVH_BLOCK_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_BLOCK_LANES
#undef GRAZE_BVH_BLOCK_LANES
#else
#define GRAZE_BVH_BLOCK_LANES
#endif

#include <graze/bvh/box_set/search/pair_lists.h>
#include <graze/bvh/box_set/store/block.h>
#include <hwy/highway.h>

#include <algorithm>
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
inline constexpr std::uint32_t kAllOfRegister = (1u << hn::MaxLanes(Tag())) - 1;
static_assert(std::endian::native == std::endian::little);

HWY_INLINE std::uint32_t bits_of(Mask mask) {
  std::uint8_t bytes[8] = {};  // Highway may write eight bytes
  hn::StoreMaskBits(Tag(), mask, bytes);
  if constexpr (hn::MaxLanes(Tag()) <= 8) return bytes[0];  // two bytes would wait for two stores
  std::uint16_t bits;
  std::memcpy(&bits, bytes, sizeof(bits));
  return bits;
}

/// A box, each of whose high halves is in all lanes of a register.
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
HWY_INLINE std::uint32_t candidate_lanes(const Block& block, const BroadcastBox& box) {
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

/// Returns the bits of those `unsure` lanes that overlap the box by the low halves, too.
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
  std::uint32_t near;    ///< lanes that are not shown to be apart from the box
  std::uint32_t unsure;  ///< those of these whose high halves are equal, so that the low ones
                         ///< decide
};

/// Finds both kinds of lanes by the interval that each has in common with the box along each axis.
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
    const std::uint32_t near = ~bits_of(is_far) & kAllOfRegister;
    sum.near |= near << lane;
    sum.unsure |= (near & bits_of(is_equal)) << lane;
  }
  return sum;
}

// Only the widest registers can be packed in one instruction. Highway 1.0.3 packs others by a table
// that g++ 12.2 copies to the stack each time; there a loop over the bits is faster.
inline constexpr bool kPacks = hn::MaxLanes(Tag()) == kLanes;

/// Returns the lanes whose bits are set, one after the other.
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
  // Four numbers are written whether they are there or not.
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
  // Two pairs are written whether they are there or not.
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

/// Pairs of blocks of boxes, met a batch at a time. Each stage runs over a plain queue without a
/// branch, because what a pair of blocks holds cannot be foreseen.
class BlockBatch {
 public:
  HWY_INLINE BlockBatch(const TreeView& a, const TreeView& b, PairBuffer& out)
      : tree_{&a, &b}, out_(out) {}

  HWY_INLINE void add(std::uint32_t a, std::uint32_t b) {
    pairs_[pair_count_++] = {{a, b}};
    if (pair_count_ == kPairs) flush();
  }

  HWY_NOINLINE void flush() {
    std::uint32_t* end = rows_;
    for (std::uint32_t i = 0; i < pair_count_; ++i) {
      prefetch(pairs_[std::min(i + kAhead, pair_count_ - 1)]);
      end = list_rows(i, end);
    }
    met_ += pair_count_;
    pair_count_ = 0;
    find_overlaps(end);
  }

  std::uint64_t met() const { return met_; }

 private:
  static constexpr std::uint32_t kPairs = 64;  ///< how many pairs a batch holds
  static constexpr std::uint32_t kAhead = 4;   ///< pairs whose blocks are fetched ahead

  struct LeafPair {
    std::uint32_t block[2];
  };
  /// Two blocks: the rows of one are boxes that are held against the lanes of the other, its
  /// columns.
  struct Meeting {
    const Block* rows;
    const Block* columns;
    const std::uint32_t* row_proxies;
    const std::uint32_t* column_proxies;
    std::uint32_t near;       ///< the columns that overlap the bounds of the other block
    std::int32_t upper_half;  ///< all bits set; for one block with itself the top bit alone, so
                              ///< that each pair is met once, in a column above its row
    const LowBlock* low[2];   ///< low halves of the rows, and of the columns
  };

  HWY_INLINE const Block& high(int side, std::uint32_t block) const {
    return tree_[side]->level[0][block];
  }

  HWY_INLINE void prefetch(const LeafPair& pair) const {
    for (int side = 0; side < 2; ++side) {
      for (const auto& row : high(side, pair.block[side]).row)
        __builtin_prefetch(row);
      __builtin_prefetch(tree_[side]->proxy + pair.block[side] * kLanes);
    }
  }

  /// Takes as rows the boxes that overlap the bounds of the other block, from the block that has
  /// fewer of them.
  HWY_INLINE std::uint32_t* list_rows(std::uint32_t i, std::uint32_t* end) {
    const LeafPair& pair = pairs_[i];
    const std::uint32_t near[2] = {
        candidate_lanes(high(0, pair.block[0]), bounds(*tree_[1], 0, pair.block[1])),
        candidate_lanes(high(1, pair.block[1]), bounds(*tree_[0], 0, pair.block[0]))};
    const int side = std::popcount(near[0]) > std::popcount(near[1]), other = 1 - side;
    const std::uint32_t mine = pair.block[side], theirs = pair.block[other];
    const Block &rows = high(side, mine), &columns = high(other, theirs);
    meetings_[i] = {&rows,
                    &columns,
                    tree_[side]->proxy + mine * kLanes,
                    tree_[other]->proxy + theirs * kLanes,
                    near[other],
                    &rows == &columns ? INT32_MIN : -1,
                    {tree_[side]->low + mine, tree_[other]->low + theirs}};
    return list_bits(near[side], i * kLanes, end);
  }

  /// Appends the boxes that the rows overlap, exactly.
  HWY_INLINE void find_overlaps(const std::uint32_t* end_of_rows) {
    const auto count = static_cast<std::size_t>(end_of_rows - rows_);
    BoxPair* end = out_.room_for((count + 1) * kLanes);
    for (const std::uint32_t* row = rows_; row != end_of_rows; ++row) {
      const Meeting& meeting = meetings_[*row / kLanes];
      const std::uint32_t lane = *row & (kLanes - 1);
      const NearLanes found = near_and_unsure(*meeting.columns, BroadcastBox(*meeting.rows, lane));
      // If a block meets itself, only the columns above the row's own count: bits lane + 1 and up.
      const std::uint32_t wanted =
          meeting.near & static_cast<std::uint32_t>(meeting.upper_half >> (30 - lane));
      std::uint32_t overlapping = found.near & wanted;
      const std::uint32_t unsure = found.unsure & wanted;
      if (HWY_UNLIKELY(unsure != 0)) {
        overlapping &= ~unsure;
        overlapping |= decided_lanes(*meeting.columns, *meeting.low[1],
                                     lane_box(*meeting.rows, *meeting.low[0], lane), unsure);
      }
      end = list_pairs(meeting.row_proxies[lane], meeting.column_proxies, overlapping, end);
    }
    out_.set_end(end);
  }

  const TreeView* tree_[2];
  PairBuffer& out_;
  std::uint32_t pair_count_ = 0;
  std::uint64_t met_ = 0;
  LeafPair pairs_[kPairs];
  Meeting meetings_[kPairs];
  std::uint32_t rows_[(kPairs + 1) * kLanes];  ///< 16 times the number of the meeting plus the lane
};

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
