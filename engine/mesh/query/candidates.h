#pragma once

// Private to engine/mesh.

#include <graze/bvh/traverse/traversal.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/work.h>
#include <graze/narrowphase/touch.h>
#include <graze/narrowphase/triangle_pair/triangle_pair_batch.h>

#include <bit>

namespace graze {

/// Pairs of placed triangles on their way from the trees to the exact tests.
class Candidates {
 public:
  static constexpr std::size_t kCapacity = narrowphase::TrianglePairBatch::kCapacity;

  Candidates(Touch touch, Work& work) : touch_(touch), work_(work) {}

  bool is_full() const { return batch_.is_full(); }

  void add(TrianglePair pair, const Triangle& triangle_a, const Triangle& triangle_b) {
    pairs_[batch_.size()] = pair;
    batch_.add(triangle_a, triangle_b);
  }

  /// Empties the batch: calls `on_pair(pair)` for each pair that meets, until it answers Stop.
  template <typename OnPair>
  bvh::Walk decide(OnPair&& on_pair) {
    const std::size_t size = batch_.size();
    if (size == 0) return bvh::Walk::Continue;
    const narrowphase::Verdicts verdicts = narrowphase::triage(batch_);
    batch_.clear();
    work_.triangle_tests += size;
    // Lanes of two that surely cross count as touching, too.
    std::uint32_t open = ((1u << size) - 1) & ~verdicts.apart;
    while (open != 0) {
      const int i = std::countr_zero(open);
      open &= open - 1;
      const bool is_sure = (verdicts.touching >> i & 1) != 0;
      if (!is_sure && !meet_though_unsure(batch_.triangle_a(i), batch_.triangle_b(i))) continue;
      if (on_pair(pairs_[i]) == bvh::Walk::Stop) return bvh::Walk::Stop;
    }
    return bvh::Walk::Continue;
  }

 private:
  bool meet_though_unsure(const Triangle& triangle_a, const Triangle& triangle_b) {
    const narrowphase::Decision decision =
        narrowphase::decide_unsure(triangle_a, triangle_b, touch_);
    work_.exact_tests += decision.stage == narrowphase::Stage::Exact;
    return decision.is_hit;
  }

  Touch touch_;
  Work& work_;
  narrowphase::TrianglePairBatch batch_;
  TrianglePair pairs_[kCapacity];
};

}  // namespace graze
