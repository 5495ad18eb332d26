#pragma once

// This is private to engine/mesh.

#include <graze/bvh/traverse/traversal.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/work.h>
#include <graze/narrowphase/touch.h>
#include <graze/narrowphase/triangle_pair/triangle_pair_batch.h>

#include <cstddef>
#include <cstdint>

namespace graze {

/// Pairs of triangles on their way from the trees to the exact tests: those that surely cross wait
/// for those that came before, so that all are handed up in their order.
class Candidates {
 public:
  static constexpr std::size_t kCapacity = 64;

  Candidates(Touch touch, Work& work) : touch_(touch), work_(work) {}

  bool is_full() const { return size_ == kCapacity || batch_.is_full(); }

  void add(TrianglePair pair, const Triangle& triangle_a, const Triangle& triangle_b) {
    pairs_[size_++] = pair;
    batch_.add(triangle_a, triangle_b);
  }

  void add_crossing(TrianglePair pair) {
    crossing_ |= std::uint64_t{1} << size_;
    pairs_[size_++] = pair;
  }

  /// Empties the batch: calls `on_pair(pair)` for each pair that meets, until it answers Stop.
  template <typename OnPair>
  bvh::Walk decide(OnPair&& on_pair) {
    const std::size_t size = size_;
    if (size == 0) return bvh::Walk::Continue;
    narrowphase::Verdicts verdicts;
    if (batch_.size() != 0) verdicts = narrowphase::triage(batch_);
    work_.triangle_tests += batch_.size();
    bvh::Walk next = bvh::Walk::Continue;
    int lane = 0;
    for (std::size_t i = 0; i < size && next == bvh::Walk::Continue; ++i) {
      const bool is_met = (crossing_ >> i & 1) != 0 || does_lane_meet(verdicts, lane++);
      if (is_met) next = on_pair(pairs_[i]);
    }
    batch_.clear();
    size_ = 0;
    crossing_ = 0;
    return next;
  }

 private:
  bool does_lane_meet(const narrowphase::Verdicts& verdicts, int lane) {
    if ((verdicts.apart >> lane & 1) != 0) return false;
    // Lanes of two triangles that surely cross count as touching, too.
    if ((verdicts.touching >> lane & 1) != 0) return true;
    return meet_though_unsure(batch_.triangle_a(lane), batch_.triangle_b(lane));
  }

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
  std::uint64_t crossing_ = 0;  ///< bits of `pairs_`: the others are the lanes of the batch
  std::size_t size_ = 0;
};

}  // namespace graze
