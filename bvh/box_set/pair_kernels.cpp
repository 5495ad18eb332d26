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

/// Pairs of blocks of boxes, met a batch at a time. Each stage runs over plain queues, because what
/// a pair of blocks holds cannot be foreseen: a branch on it costs more than comparing in vain.
class LeafBatch {
 public:
  HWY_INLINE LeafBatch(const TreeView& a, const TreeView& b, PairBuffer& out)
      : tree_{&a, &b}, out_(out) {}

  HWY_INLINE void add(std::uint32_t a, std::uint32_t b) {
    pairs_[pair_count_++] = {a, b};
    if (pair_count_ == kPairs) flush();
  }

  HWY_NOINLINE void flush() {
    row_count_ = 0;
    for (std::size_t i = 0; i < pair_count_; ++i) {
      prefetch(pairs_[std::min(i + kAhead, pair_count_ - 1)]);
      list_rows(pairs_[i]);
    }
    met_ += pair_count_;
    pair_count_ = 0;
    find_hits();
    emit();
  }

  std::uint64_t met() const { return met_; }

 private:
  static constexpr std::size_t kPairs = 128;
  static constexpr std::size_t kAhead = 4;

  struct LeafPair {
    std::uint32_t block[2];
  };
  /// A box of one block, and lanes of the other block that it may overlap.
  struct Row {
    std::uint32_t block;
    std::uint32_t columns;
    std::uint16_t mask;
    std::uint8_t lane;
    std::uint8_t side;  // 0: the box is in tree a
  };

  HWY_INLINE const Block& high(int side, std::uint32_t block) const {
    return tree_[side]->level[0][block];
  }

  HWY_INLINE void prefetch(const LeafPair& pair) const {
    for (int side = 0; side < 2; ++side) {
      for (const auto& row : high(side, pair.block[side]).row)
        __builtin_prefetch(row);
      __builtin_prefetch(tree_[side]->owner + pair.block[side] * kLanes);
    }
  }

  /// Which boxes of the block with fewer of them reach the other block; all, within one block.
  HWY_INLINE void list_rows(const LeafPair& pair) {
    const Block& a = high(0, pair.block[0]);
    const Block& b = high(1, pair.block[1]);
    if (&a == &b) {
      const std::uint32_t taken = near_lanes(a, bounds(*tree_[0], 0, pair.block[0]));
      for (std::uint32_t i = 0; i + 1 < kLanes; ++i) {
        rows_[row_count_++] = {pair.block[0], pair.block[0],
                               static_cast<std::uint16_t>(taken & (0xfffeu << i)),
                               static_cast<std::uint8_t>(i), 0};
      }
      return;
    }
    const std::uint32_t mask_a = near_lanes(a, bounds(*tree_[1], 0, pair.block[1]));
    const std::uint32_t mask_b = near_lanes(b, bounds(*tree_[0], 0, pair.block[0]));
    const auto side = static_cast<std::uint8_t>(std::popcount(mask_a) > std::popcount(mask_b));
    std::uint32_t lanes = side == 0 ? mask_a : mask_b;
    Row row = {pair.block[side], pair.block[1 - side],
               static_cast<std::uint16_t>(side == 0 ? mask_b : mask_a), 0, side};
    // Four are written whether they are there or not.
    const std::size_t count = static_cast<std::size_t>(std::popcount(lanes));
    std::size_t end = row_count_;
    for (int i = 0; i < 4; ++i, lanes &= lanes - 1) {
      row.lane = static_cast<std::uint8_t>(std::countr_zero(lanes));
      rows_[end++] = row;
    }
    for (; HWY_UNLIKELY(lanes != 0); lanes &= lanes - 1) {
      row.lane = static_cast<std::uint8_t>(std::countr_zero(lanes));
      rows_[end++] = row;
    }
    row_count_ += count;
  }

  /// Keeps the rows that overlap anything, exactly.
  HWY_INLINE void find_hits() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < row_count_; ++i) {
      Row row = rows_[i];
      const Block& columns = high(1 - row.side, row.columns);
      const Spread box(high(row.side, row.block), row.lane);
      std::uint32_t hits = near_lanes(columns, box) & row.mask;
      const std::uint32_t unsure = hits & ~sure_lanes(columns, box);
      if (HWY_UNLIKELY(unsure != 0)) {
        const LowBlock* low[2] = {tree_[0]->low, tree_[1]->low};
        hits &= ~unsure;
        hits |=
            settle(columns, low[1 - row.side][row.columns],
                   lane_box(high(row.side, row.block), low[row.side][row.block], row.lane), unsure);
      }
      row.mask = static_cast<std::uint16_t>(hits);
      rows_[kept] = row;
      kept += hits != 0;
    }
    row_count_ = kept;
  }

  HWY_INLINE void emit() {
    BoxPair* end = out_.room_for(row_count_ * kLanes + 2);
    for (std::size_t i = 0; i < row_count_; ++i) {
      const Row& row = rows_[i];
      const std::uint32_t mine = tree_[row.side]->owner[row.block * kLanes + row.lane];
      const std::uint32_t* others = tree_[1 - row.side]->owner + row.columns * kLanes;
      std::uint32_t hits = row.mask;
      // Two are written whether they are there or not.
      const std::uint32_t first = others[std::countr_zero(hits)];
      const std::uint32_t second = others[std::countr_zero((hits & (hits - 1)) | 0x8000u)];
      end[0] = {std::min(mine, first), std::max(mine, first)};
      end[1] = {std::min(mine, second), std::max(mine, second)};
      hits &= hits - 1;
      end += 1 + (hits != 0);
      for (hits &= hits - 1; HWY_UNLIKELY(hits != 0); hits &= hits - 1) {
        const std::uint32_t other = others[std::countr_zero(hits)];
        *end++ = {std::min(mine, other), std::max(mine, other)};
      }
    }
    out_.set_end(end);
  }

  const TreeView* tree_[2];
  PairBuffer& out_;
  std::size_t pair_count_ = 0;
  std::size_t row_count_ = 0;
  std::uint64_t met_ = 0;
  LeafPair pairs_[kPairs];
  Row rows_[kPairs * kLanes + 4];
};

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
  LeafBatch leaves(a, b, out);
  if (start.level_a == 0 && start.level_b == 0) leaves.add(start.a, start.b);
  BlockPair stack[kStackSize];
  BlockPair* end = stack;
  if (start.level_a != 0 || start.level_b != 0) *end++ = start;
  while (end != stack) {
    const BlockPair pair = *--end;
    open(a, b, pair, [&](const BlockPair& next) {
      if (next.level_a == 0 && next.level_b == 0) {
        leaves.add(next.a, next.b);
      } else {
        *end++ = next;
      }
    });
  }
  leaves.flush();
  return leaves.met();
}

void split_pair(const TreeView& a, const TreeView& b, BlockPair start,
                std::vector<BlockPair>& out) {
  open(a, b, start, [&](const BlockPair& next) { out.push_back(next); });
}

void find_overlapping(const TreeView& tree, const OrderedBox& box,
                      std::vector<std::uint32_t>& out) {
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
        const std::uint32_t next =
            entry.block * kLanes + static_cast<std::uint32_t>(std::countr_zero(hits));
        for (const auto& row : tree.level[entry.level - 1][next].row)
          __builtin_prefetch(row);
        *end++ = {next, entry.level - 1};
      }
      continue;
    }
    if (hits == 0) continue;
    const std::uint32_t sure = hits & sure_lanes(block, high);
    if (sure != hits) hits = sure | settle(block, tree.low[entry.block], box, hits & ~sure);
    for (; hits != 0; hits &= hits - 1)
      out.push_back(
          tree.owner[entry.block * kLanes + static_cast<std::uint32_t>(std::countr_zero(hits))]);
  }
}

HWY_INLINE std::uint32_t exact_lanes(const Block& block, const LowBlock& low, const Spread& high,
                                     const OrderedBox& box) {
  const std::uint32_t near = near_lanes(block, high);
  const std::uint32_t unsure = near & ~sure_lanes(block, high);
  return HWY_UNLIKELY(unsure != 0) ? (near & ~unsure) | settle(block, low, box, unsure) : near;
}

void find_overlapping_either(const TreeView& tree, const OrderedBox& before,
                             const OrderedBox& after, std::vector<MoverHit>& out) {
  OrderedBox both;
  for (std::size_t c = 0; c < 3; ++c) {
    both[c] = std::min(before[c], after[c]);
    both[c + 3] = std::max(before[c + 3], after[c + 3]);
  }
  const Spread high(both), high_before(before), high_after(after);
  std::uint32_t blocks[kMaxLevels * kLanes], levels[kMaxLevels * kLanes];
  std::size_t end = 1;
  blocks[0] = 0, levels[0] = static_cast<std::uint32_t>(tree.top);
  while (end != 0) {
    --end;
    const std::uint32_t level = levels[end], at = blocks[end];
    const Block& block = tree.level[level][at];
    if (level != 0) {
      for (std::uint32_t hits = near_lanes(block, high); hits != 0; hits &= hits - 1) {
        const std::uint32_t next = at * kLanes + static_cast<std::uint32_t>(std::countr_zero(hits));
        for (const auto& row : tree.level[level - 1][next].row)
          __builtin_prefetch(row);
        blocks[end] = next, levels[end++] = level - 1;
      }
      continue;
    }
    const std::uint32_t was = exact_lanes(block, tree.low[at], high_before, before);
    const std::uint32_t is = exact_lanes(block, tree.low[at], high_after, after);
    for (std::uint32_t hits = was | is; hits != 0; hits &= hits - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(hits));
      out.push_back({tree.owner[at * kLanes + lane], static_cast<std::uint16_t>(was >> lane & 1),
                     static_cast<std::uint16_t>(is >> lane & 1)});
    }
  }
}

template <typename Join, typename Reduce>
HWY_INLINE std::int32_t reduce_row(const std::int32_t* row, const Join& join,
                                   const Reduce& reduce) {
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
      parent.row[c][lane] = reduce_row(
          below[i].row[c], [](Lanes x, Lanes y) { return hn::Min(x, y); },
          [&](Lanes x) { return hn::MinOfLanes(tag, x); });
      parent.row[c + 3][lane] = reduce_row(
          below[i].row[c + 3], [](Lanes x, Lanes y) { return hn::Max(x, y); },
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
HWY_EXPORT(find_overlapping_either);
HWY_EXPORT(refit_blocks);

std::uint64_t find_pairs(const TreeView& a, const TreeView& b, BlockPair start, PairBuffer& out) {
  return HWY_DYNAMIC_DISPATCH(find_pairs)(a, b, start, out);
}

void split_pair(const TreeView& a, const TreeView& b, BlockPair start,
                std::vector<BlockPair>& out) {
  HWY_DYNAMIC_DISPATCH(split_pair)(a, b, start, out);
}

void find_overlapping(const TreeView& tree, const OrderedBox& box,
                      std::vector<std::uint32_t>& out) {
  HWY_DYNAMIC_DISPATCH(find_overlapping)(tree, box, out);
}

void find_overlapping_either(const TreeView& tree, const OrderedBox& before,
                             const OrderedBox& after, std::vector<MoverHit>& out) {
  HWY_DYNAMIC_DISPATCH(find_overlapping_either)(tree, before, after, out);
}

void refit_blocks(const Block* below, std::uint32_t first, std::uint32_t last, Block* above) {
  HWY_DYNAMIC_DISPATCH(refit_blocks)(below, first, last, above);
}

}  // namespace graze::bvh
#endif
