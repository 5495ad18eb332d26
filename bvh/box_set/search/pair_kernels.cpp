// The kernels for each SIMD target that the compiler knows; the widest that the CPU has is chosen
// when the program runs. They compare integers, so that all of them agree.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/bvh/box_set/search/pair_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/bvh/box_set/search/pair_kernels.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<std::int32_t, kLanes>;
using NumberTag = hn::RebindToUnsigned<Tag>;
using Lanes = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;

// A pair of levels adds at most 256 pairs to the stack and takes one away.
constexpr std::size_t kStackSize = 2 * kMaxLevels * kLanes * kLanes;

// A register that is not the widest holds part of a block; bits of its lanes are the lowest ones.
constexpr std::uint32_t kAllHere = (1u << hn::MaxLanes(Tag())) - 1;
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
HWY_NOINLINE std::uint32_t decided_lanes(const Block& high, const LowBlock& low,
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
struct Verdict {
  std::uint32_t near;    // not shown to be apart
  std::uint32_t unsure;  // of these: two high halves are equal, the low ones decide
};

/// As near_lanes() and sure_lanes(), by what the two have in common along each axis: along an axis
/// on which high halves are equal that has no length.
HWY_INLINE Verdict verdict(const Block& block, const BroadcastBox& box) {
  const Tag tag;
  const hn::RebindToUnsigned<Tag> lengths;
  Verdict sum = {0, 0};
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

// Only the widest registers can be packed in one instruction. Highway 1.0.3 packs others by a table
// that g++ 12.2 copies to the stack each time; there a loop over the bits is faster.
constexpr bool kPacks = hn::MaxLanes(Tag()) == kLanes;

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

/// Pairs of blocks of boxes, met a batch at a time. Each stage runs over a plain queue without a
/// branch, because what a pair of blocks holds cannot be foreseen.
class LeafBatch {
 public:
  HWY_INLINE LeafBatch(const TreeView& a, const TreeView& b, PairBuffer& out)
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
    find_hits(end);
  }

  std::uint64_t met() const { return met_; }

 private:
  static constexpr std::uint32_t kPairs = 64;
  static constexpr std::uint32_t kAhead = 4;

  struct LeafPair {
    std::uint32_t block[2];
  };
  /// Two blocks: of one the rows are taken, boxes that are held against the lanes of the other.
  struct Meeting {
    const Block* rows;
    const Block* columns;
    const std::uint32_t* row_proxies;
    const std::uint32_t* column_proxies;
    std::uint32_t near;     // of the columns
    std::int32_t triangle;  // within one block its top bit, so that each pair is met once; else all
    const LowBlock* low[2];  // of the rows, of the columns
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

  /// Takes the boxes that reach the other block as rows, of the block that has fewer of them.
  HWY_INLINE std::uint32_t* list_rows(std::uint32_t i, std::uint32_t* end) {
    const LeafPair& pair = pairs_[i];
    const std::uint32_t near[2] = {
        near_lanes(high(0, pair.block[0]), bounds(*tree_[1], 0, pair.block[1])),
        near_lanes(high(1, pair.block[1]), bounds(*tree_[0], 0, pair.block[0]))};
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

  /// Appends what the rows overlap, exactly.
  HWY_INLINE void find_hits(const std::uint32_t* end_of_rows) {
    const auto count = static_cast<std::size_t>(end_of_rows - rows_);
    BoxPair* end = out_.room_for((count + 1) * kLanes);
    for (const std::uint32_t* row = rows_; row != end_of_rows; ++row) {
      const Meeting& meeting = meetings_[*row / kLanes];
      const std::uint32_t lane = *row & (kLanes - 1);
      const Verdict found = verdict(*meeting.columns, BroadcastBox(*meeting.rows, lane));
      // Of a triangle only the columns above the row's own: bits lane + 1 and up.
      const std::uint32_t wanted =
          meeting.near & static_cast<std::uint32_t>(meeting.triangle >> (30 - lane));
      std::uint32_t hits = found.near & wanted;
      const std::uint32_t unsure = found.unsure & wanted;
      if (HWY_UNLIKELY(unsure != 0)) {
        hits &= ~unsure;
        hits |= decided_lanes(*meeting.columns, *meeting.low[1],
                              lane_box(*meeting.rows, *meeting.low[0], lane), unsure);
      }
      end = list_pairs(meeting.row_proxies[lane], meeting.column_proxies, hits, end);
    }
    out_.set_end(end);
  }

  const TreeView* tree_[2];
  PairBuffer& out_;
  std::uint32_t pair_count_ = 0;
  std::uint64_t met_ = 0;
  LeafPair pairs_[kPairs];
  Meeting meetings_[kPairs];
  std::uint32_t rows_[(kPairs + 1) * kLanes];  // 16 times the meeting plus the lane
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
      std::uint32_t hits = near_lanes(block_b, BroadcastBox(block_a, i));
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

std::uint64_t find_pairs(const TreeView& a, const TreeView& b, std::span<const BlockPair> starts,
                         PairBuffer& out) {
  LeafBatch leaves(a, b, out);
  BlockPair stack[kStackSize];
  for (const BlockPair& start : starts) {
    BlockPair* end = stack;
    const auto push = [&](const BlockPair& next) {
      if (next.level_a == 0 && next.level_b == 0) {
        leaves.add(next.a, next.b);
      } else {
        *end++ = next;
      }
    };
    push(start);
    while (end != stack)
      open(a, b, *--end, push);
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
  const BroadcastBox high(box);
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
    if (sure != hits) hits = sure | decided_lanes(block, tree.low[entry.block], box, hits & ~sure);
    for (; hits != 0; hits &= hits - 1)
      out.push_back(
          tree.proxy[entry.block * kLanes + static_cast<std::uint32_t>(std::countr_zero(hits))]);
  }
}

HWY_INLINE std::uint32_t exact_lanes(const Block& block, const LowBlock& low,
                                     const BroadcastBox& high, const OrderedBox& box) {
  const std::uint32_t near = near_lanes(block, high);
  const std::uint32_t unsure = near & ~sure_lanes(block, high);
  return HWY_UNLIKELY(unsure != 0) ? (near & ~unsure) | decided_lanes(block, low, box, unsure)
                                   : near;
}

/// The movers' high halves: mover i in lane i.
HWY_INLINE Block high_halves(std::span<const OrderedBox> boxes) {
  Block block = empty_block();
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t c = 0; c < 6; ++c)
      block.row[c][i] = high_half(boxes[i][c]);
  }
  return block;
}

/// The blocks one level down that the movers may reach.
HWY_INLINE void step_down(const TreeView& tree, int level, const Block& before, const Block& after,
                          Lookup& lookup) {
  lookup.below.clear();
  for (const Reached& at : lookup.here) {
    const Block& block = tree.level[level][at.block];
    std::uint32_t hits = near_lanes(block, BroadcastBox(before, at.mover)) |
                         near_lanes(block, BroadcastBox(after, at.mover));
    for (; hits != 0; hits &= hits - 1) {
      const std::uint32_t next =
          at.block * kLanes + static_cast<std::uint32_t>(std::countr_zero(hits));
      for (const auto& row : tree.level[level - 1][next].row)
        __builtin_prefetch(row);
      if (level == 1) __builtin_prefetch(tree.proxy + next * kLanes);
      lookup.below.push_back({at.mover, next});
    }
  }
  lookup.here.swap(lookup.below);
}

void find_overlapping_either(const TreeView& tree, std::span<const OrderedBox> before,
                             std::span<const OrderedBox> after, Lookup& lookup,
                             std::vector<MoverHit>& out) {
  const Block high_before = high_halves(before), high_after = high_halves(after);
  lookup.here.clear();
  for (std::uint32_t mover = 0; mover < before.size(); ++mover)
    lookup.here.push_back({mover, 0});
  for (int level = tree.top; level > 0; --level)
    step_down(tree, level, high_before, high_after, lookup);
  for (const auto& [mover, at] : lookup.here) {
    const Block& block = tree.level[0][at];
    const std::uint32_t was =
        exact_lanes(block, tree.low[at], BroadcastBox(high_before, mover), before[mover]);
    const std::uint32_t is =
        exact_lanes(block, tree.low[at], BroadcastBox(high_after, mover), after[mover]);
    for (std::uint32_t hits = was | is; hits != 0; hits &= hits - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(hits));
      out.push_back({tree.proxy[at * kLanes + lane], static_cast<std::uint8_t>(mover),
                     static_cast<std::uint8_t>(was >> lane & 1),
                     static_cast<std::uint8_t>(is >> lane & 1)});
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

std::uint64_t find_pairs(const TreeView& a, const TreeView& b, std::span<const BlockPair> starts,
                         PairBuffer& out) {
  return HWY_DYNAMIC_DISPATCH(find_pairs)(a, b, starts, out);
}

void split_pair(const TreeView& a, const TreeView& b, BlockPair start,
                std::vector<BlockPair>& out) {
  HWY_DYNAMIC_DISPATCH(split_pair)(a, b, start, out);
}

void find_overlapping(const TreeView& tree, const OrderedBox& box,
                      std::vector<std::uint32_t>& out) {
  HWY_DYNAMIC_DISPATCH(find_overlapping)(tree, box, out);
}

void find_overlapping_either(const TreeView& tree, std::span<const OrderedBox> before,
                             std::span<const OrderedBox> after, Lookup& lookup,
                             std::vector<MoverHit>& out) {
  HWY_DYNAMIC_DISPATCH(find_overlapping_either)(tree, before, after, lookup, out);
}

void refit_blocks(const Block* below, std::uint32_t first, std::uint32_t last, Block* above) {
  HWY_DYNAMIC_DISPATCH(refit_blocks)(below, first, last, above);
}

}  // namespace graze::bvh
#endif
