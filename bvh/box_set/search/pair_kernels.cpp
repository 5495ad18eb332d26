// The kernels for each SIMD target that the compiler knows; the widest that the CPU has is chosen
// when the program runs. They compare integers, so that all of them agree.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/bvh/box_set/search/pair_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/bvh/box_set/search/block_lanes-inl.h>
#include <graze/bvh/box_set/search/pair_kernels.h>
#include <hwy/highway.h>

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

// A pair of levels adds at most 256 pairs to the stack and takes one away.
constexpr std::size_t kStackSize = 2 * kMaxLevels * kLanes * kLanes;

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
    std::uint32_t rows = candidate_lanes(block_a, bounds(b, pair.level_b, pair.b));
    for (; rows != 0; rows &= rows - 1) {
      const auto i = static_cast<std::uint32_t>(std::countr_zero(rows));
      std::uint32_t overlapping = candidate_lanes(block_b, BroadcastBox(block_a, i));
      if (is_same) overlapping &= 0xffffu << i;
      next.a = pair.a * kLanes + i;
      for (; overlapping != 0; overlapping &= overlapping - 1) {
        next.b = pair.b * kLanes + static_cast<std::uint32_t>(std::countr_zero(overlapping));
        push(next);
      }
    }
  } else if (pair.level_a > pair.level_b) {
    --next.level_a;
    std::uint32_t overlapping = candidate_lanes(block_a, bounds(b, pair.level_b, pair.b));
    for (; overlapping != 0; overlapping &= overlapping - 1) {
      next.a = pair.a * kLanes + static_cast<std::uint32_t>(std::countr_zero(overlapping));
      push(next);
    }
  } else {
    --next.level_b;
    std::uint32_t overlapping = candidate_lanes(block_b, bounds(a, pair.level_a, pair.a));
    for (; overlapping != 0; overlapping &= overlapping - 1) {
      next.b = pair.b * kLanes + static_cast<std::uint32_t>(std::countr_zero(overlapping));
      push(next);
    }
  }
}

std::uint64_t find_pairs(const TreeView& a, const TreeView& b, std::span<const BlockPair> starts,
                         PairBuffer& out) {
  BlockBatch leaves(a, b, out);
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
    std::uint32_t overlapping = candidate_lanes(block, high);
    if (entry.level != 0) {
      for (; overlapping != 0; overlapping &= overlapping - 1) {
        const std::uint32_t next =
            entry.block * kLanes + static_cast<std::uint32_t>(std::countr_zero(overlapping));
        for (const auto& row : tree.level[entry.level - 1][next].row)
          __builtin_prefetch(row);
        *end++ = {next, entry.level - 1};
      }
      continue;
    }
    if (overlapping == 0) continue;
    const std::uint32_t sure = overlapping & sure_lanes(block, high);
    if (sure != overlapping)
      overlapping = sure | decided_lanes(block, tree.low[entry.block], box, overlapping & ~sure);
    for (; overlapping != 0; overlapping &= overlapping - 1)
      out.push_back(tree.proxy[entry.block * kLanes +
                               static_cast<std::uint32_t>(std::countr_zero(overlapping))]);
  }
}

HWY_INLINE std::uint32_t exact_lanes(const Block& block, const LowBlock& low,
                                     const BroadcastBox& high, const OrderedBox& box) {
  const std::uint32_t near = candidate_lanes(block, high);
  const std::uint32_t unsure = near & ~sure_lanes(block, high);
  return HWY_UNLIKELY(unsure != 0) ? (near & ~unsure) | decided_lanes(block, low, box, unsure)
                                   : near;
}

/// Returns the movers' high halves: mover i is in lane i.
HWY_INLINE Block high_halves(std::span<const OrderedBox> boxes) {
  Block block = empty_block();
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t c = 0; c < 6; ++c)
      block.row[c][i] = high_half(boxes[i][c]);
  }
  return block;
}

/// Lists the blocks one level down that the movers may overlap.
HWY_INLINE void step_down(const TreeView& tree, int level, const Block& before, const Block& after,
                          Lookup& lookup) {
  lookup.below.clear();
  for (const Reached& at : lookup.reached) {
    const Block& block = tree.level[level][at.block];
    std::uint32_t overlapping = candidate_lanes(block, BroadcastBox(before, at.mover)) |
                                candidate_lanes(block, BroadcastBox(after, at.mover));
    for (; overlapping != 0; overlapping &= overlapping - 1) {
      const std::uint32_t next =
          at.block * kLanes + static_cast<std::uint32_t>(std::countr_zero(overlapping));
      for (const auto& row : tree.level[level - 1][next].row)
        __builtin_prefetch(row);
      if (level == 1) __builtin_prefetch(tree.proxy + next * kLanes);
      lookup.below.push_back({at.mover, next});
    }
  }
  lookup.reached.swap(lookup.below);
}

void find_overlapping_either(const TreeView& tree, std::span<const OrderedBox> before,
                             std::span<const OrderedBox> after, Lookup& lookup,
                             std::vector<MoverOverlap>& out) {
  const Block high_before = high_halves(before), high_after = high_halves(after);
  lookup.reached.clear();
  for (std::uint32_t mover = 0; mover < before.size(); ++mover)
    lookup.reached.push_back({mover, 0});
  for (int level = tree.top; level > 0; --level)
    step_down(tree, level, high_before, high_after, lookup);
  for (const auto& [mover, at] : lookup.reached) {
    const Block& block = tree.level[0][at];
    const std::uint32_t overlapped =
        exact_lanes(block, tree.low[at], BroadcastBox(high_before, mover), before[mover]);
    const std::uint32_t overlaps =
        exact_lanes(block, tree.low[at], BroadcastBox(high_after, mover), after[mover]);
    for (std::uint32_t overlapping = overlapped | overlaps; overlapping != 0;
         overlapping &= overlapping - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(overlapping));
      out.push_back({tree.proxy[at * kLanes + lane], static_cast<std::uint8_t>(mover),
                     static_cast<std::uint8_t>(overlapped >> lane & 1),
                     static_cast<std::uint8_t>(overlaps >> lane & 1)});
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
                             std::vector<MoverOverlap>& out) {
  HWY_DYNAMIC_DISPATCH(find_overlapping_either)(tree, before, after, lookup, out);
}

}  // namespace graze::bvh
#endif
