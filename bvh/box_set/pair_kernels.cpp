// The kernels for each SIMD target that the compiler knows; the widest that the CPU has is chosen
// when the program runs. They compare integers, so that all of them agree.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/bvh/box_set/pair_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/bvh/box_set/pair_kernels.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<std::int32_t, kLanes>;
using Lanes = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;

// A pair of levels adds at most 256 pairs to the stack and takes one away.
constexpr std::size_t kStackSize = 2 * kMaxLevels * kLanes * kLanes;

HWY_INLINE std::uint32_t bits_of(Mask mask) {
  std::uint8_t bytes[8] = {};  // Highway may write eight bytes
  hn::StoreMaskBits(Tag(), mask, bytes);
  return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
}

/// One box, its halves in all lanes.
struct Spread {
  Lanes row[6];
  HWY_INLINE Spread(const Block& block, std::uint32_t lane) {
    for (int c = 0; c < 6; ++c)
      row[c] = hn::Set(Tag(), block.row[c][lane]);
  }
  HWY_INLINE explicit Spread(const OrderedBox& box) {
    for (std::size_t c = 0; c < 6; ++c)
      row[c] = hn::Set(Tag(), high_half(box[c]));
  }
};

/// Bit i is set unless the high halves alone show that lane i and the box share no point.
HWY_INLINE std::uint32_t near_lanes(const Block& block, const Spread& box) {
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
HWY_INLINE std::uint32_t sure_lanes(const Block& block, const Spread& box) {
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

/// Clears the bits of `unsure` lanes which the low halves show to be apart from the box.
HWY_NOINLINE std::uint32_t settle(const Block& high, const LowBlock& low, const OrderedBox& box,
                                  std::uint32_t unsure) {
  std::uint32_t bits = 0;
  for (; unsure != 0; unsure &= unsure - 1) {
    const auto lane = static_cast<std::uint32_t>(std::countr_zero(unsure));
    if (overlap(lane_box(high, low, lane), box)) bits |= 1u << lane;
  }
  return bits;
}

HWY_INLINE Spread bounds(const TreeView& tree, int level, std::uint32_t block) {
  return Spread(tree.level[level + 1][block >> kLaneBits], block & (kLanes - 1));
}

/// Block i of this side of a pair of trees.
struct Side {
  const Block* high;
  const LowBlock* low;
  const std::uint32_t* owner;
  HWY_INLINE Side(const TreeView& tree, std::uint32_t block)
      : high(tree.level[0] + block), low(tree.low + block), owner(tree.owner + block * kLanes) {}
};

/// For each lane of `rows` in the mask the lanes among `columns` of the other side that it
/// overlaps, where the pair `is_within` one block only those after itself.
HWY_INLINE void meet(const Side& rows, std::uint32_t row_mask, const Side& columns,
                     std::uint32_t column_mask, std::uint32_t within, PairBuffer& out) {
  BoxPair* end = out.room_for(kLanes * kLanes);
  for (; row_mask != 0; row_mask &= row_mask - 1) {
    const auto i = static_cast<std::uint32_t>(std::countr_zero(row_mask));
    const Spread box(*rows.high, i);
    const std::uint32_t mask = column_mask & ~(within & ((2u << i) - 1));
    std::uint32_t hits = near_lanes(*columns.high, box) & mask;
    if (hits == 0) continue;
    const std::uint32_t sure = hits & sure_lanes(*columns.high, box);
    if (sure != hits) {
      hits = sure | settle(*columns.high, *columns.low, lane_box(*rows.high, *rows.low, i), hits & ~sure);
    }
    const std::uint32_t mine = rows.owner[i];
    for (; hits != 0; hits &= hits - 1) {
      const std::uint32_t other = columns.owner[std::countr_zero(hits)];
      *end++ = {std::min(mine, other), std::max(mine, other)};
    }
  }
  out.set_end(end);
}

HWY_INLINE void meet_leaves(const TreeView& a, const TreeView& b, BlockPair pair, PairBuffer& out) {
  const Side side_a(a, pair.a);
  const Side side_b(b, pair.b);
  if (side_a.high == side_b.high) {
    meet(side_a, 0xffff, side_a, 0xffff, 0xffff, out);
    return;
  }
  const std::uint32_t mask_a = near_lanes(*side_a.high, bounds(b, 0, pair.b));
  const std::uint32_t mask_b = near_lanes(*side_b.high, bounds(a, 0, pair.a));
  const bool a_has_fewer = std::popcount(mask_a) <= std::popcount(mask_b);
  meet(a_has_fewer ? side_a : side_b, a_has_fewer ? mask_a : mask_b,
       a_has_fewer ? side_b : side_a, a_has_fewer ? mask_b : mask_a, 0, out);
}

/// Hands the pairs of blocks one step down from `pair` to `push`. Of blocks on different levels the
/// higher one is opened.
template <typename Push>
HWY_INLINE void open(const TreeView& a, const TreeView& b, BlockPair pair, const Push& push) {
  const Block& block_a = a.level[pair.level_a][pair.a];
  const Block& block_b = b.level[pair.level_b][pair.b];
  BlockPair next = pair;
  if (pair.level_a == pair.level_b) {
    --next.level_a, --next.level_b;
    const bool is_same = &block_a == &block_b;
    std::uint32_t rows = near_lanes(block_a, bounds(b, pair.level_b, pair.b));
    for (; rows != 0; rows &= rows - 1) {
      const auto i = static_cast<std::uint32_t>(std::countr_zero(rows));
      std::uint32_t hits = near_lanes(block_b, Spread(block_a, i));
      if (is_same) hits &= 0xffffu << i;
      next.a = pair.a * kLanes + i;
      for (; hits != 0; hits &= hits - 1) {
        next.b = pair.b * kLanes + static_cast<std::uint32_t>(std::countr_zero(hits));
        push(next);
      }
    }
  } else if (pair.level_a > pair.level_b) {
    --next.level_a;
    std::uint32_t hits = near_lanes(block_a, bounds(b, pair.level_b, pair.b));
    for (; hits != 0; hits &= hits - 1) {
      next.a = pair.a * kLanes + static_cast<std::uint32_t>(std::countr_zero(hits));
      push(next);
    }
  } else {
    --next.level_b;
    std::uint32_t hits = near_lanes(block_b, bounds(a, pair.level_a, pair.a));
    for (; hits != 0; hits &= hits - 1) {
      next.b = pair.b * kLanes + static_cast<std::uint32_t>(std::countr_zero(hits));
      push(next);
    }
  }
}

std::uint64_t find_pairs(const TreeView& a, const TreeView& b, BlockPair start, PairBuffer& out) {
  BlockPair stack[kStackSize];
  BlockPair* end = stack;
  *end++ = start;
  std::uint64_t met = 0;
  while (end != stack) {
    const BlockPair pair = *--end;
    if (pair.level_a == 0 && pair.level_b == 0) {
      ++met;
      meet_leaves(a, b, pair, out);
      continue;
    }
    open(a, b, pair, [&](const BlockPair& next) { *end++ = next; });
  }
  return met;
}

void split_pair(const TreeView& a, const TreeView& b, BlockPair start, std::vector<BlockPair>& out) {
  open(a, b, start, [&](const BlockPair& next) { out.push_back(next); });
}

void find_overlapping(const TreeView& tree, const OrderedBox& box, std::vector<std::uint32_t>& out) {
  struct Entry {
    std::uint32_t block;
    std::uint32_t level;
  };
  const Spread high(box);
  Entry stack[kMaxLevels * kLanes];
  Entry* end = stack;
  *end++ = {0, static_cast<std::uint32_t>(tree.top)};
  while (end != stack) {
    const Entry entry = *--end;
    const Block& block = tree.level[entry.level][entry.block];
    std::uint32_t hits = near_lanes(block, high);
    if (entry.level != 0) {
      for (; hits != 0; hits &= hits - 1) {
        *end++ = {entry.block * kLanes + static_cast<std::uint32_t>(std::countr_zero(hits)),
                  entry.level - 1};
      }
      continue;
    }
    if (hits == 0) continue;
    const std::uint32_t sure = hits & sure_lanes(block, high);
    if (sure != hits) hits = sure | settle(block, tree.low[entry.block], box, hits & ~sure);
    for (; hits != 0; hits &= hits - 1)
      out.push_back(tree.owner[entry.block * kLanes + static_cast<std::uint32_t>(std::countr_zero(hits))]);
  }
}

template <typename Join, typename Reduce>
HWY_INLINE std::int32_t reduce_row(const std::int32_t* row, const Join& join, const Reduce& reduce) {
  const Tag tag;
  Lanes all = hn::Load(tag, row);
  for (std::uint32_t lane = static_cast<std::uint32_t>(hn::Lanes(tag)); lane < kLanes;
       lane += static_cast<std::uint32_t>(hn::Lanes(tag)))
    all = join(all, hn::Load(tag, row + lane));
  return hn::GetLane(reduce(all));
}

void refit_blocks(const Block* below, std::uint32_t first, std::uint32_t last, Block* above) {
  const Tag tag;
  for (std::uint32_t i = first; i < last; ++i) {
    Block& parent = above[i >> kLaneBits];
    const std::uint32_t lane = i & (kLanes - 1);
    for (int c = 0; c < 3; ++c) {
      parent.row[c][lane] =
          reduce_row(below[i].row[c], [](Lanes x, Lanes y) { return hn::Min(x, y); },
                     [&](Lanes x) { return hn::MinOfLanes(tag, x); });
      parent.row[c + 3][lane] =
          reduce_row(below[i].row[c + 3], [](Lanes x, Lanes y) { return hn::Max(x, y); },
                     [&](Lanes x) { return hn::MaxOfLanes(tag, x); });
    }
  }
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::bvh {

HWY_EXPORT(find_pairs);
HWY_EXPORT(split_pair);
HWY_EXPORT(find_overlapping);
HWY_EXPORT(refit_blocks);

std::uint64_t find_pairs(const TreeView& a, const TreeView& b, BlockPair start, PairBuffer& out) {
  return HWY_DYNAMIC_DISPATCH(find_pairs)(a, b, start, out);
}

void split_pair(const TreeView& a, const TreeView& b, BlockPair start, std::vector<BlockPair>& out) {
  HWY_DYNAMIC_DISPATCH(split_pair)(a, b, start, out);
}

void find_overlapping(const TreeView& tree, const OrderedBox& box, std::vector<std::uint32_t>& out) {
  HWY_DYNAMIC_DISPATCH(find_overlapping)(tree, box, out);
}

void refit_blocks(const Block* below, std::uint32_t first, std::uint32_t last, Block* above) {
  HWY_DYNAMIC_DISPATCH(refit_blocks)(below, first, last, above);
}

}  // namespace graze::bvh
#endif
