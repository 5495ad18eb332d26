#pragma once

// Private to engine/mesh/rigid.

#include <graze/bvh/traverse/traversal.h>
#include <graze/engine/mesh/rigid/moving_pair.h>
#include <graze/engine/mesh/triangle_pairs.h>
#include <graze/engine/work.h>

#include <cstdint>

namespace graze {

/// Walks pairs of nodes, each with a stretch of time of its own, and looks for the first time of
/// the grid at which two triangles are as near as the limit.
class ContactWalk {
 public:
  /// When a walk ends before all is known.
  enum class End { AtFirst, AtAll };

  ContactWalk(MovingPair& pair, std::uint64_t budget, Work& work)
      : pair_(pair), low_(pair.grid().end()), budget_(budget), work_(work) {}

  /// With End::AtAll, the first such time; with End::AtFirst any, once one is known. The end of the
  /// grid if there is none: then all is further apart at all times.
  std::uint64_t run(End end);

  /// Whether the budget ended first, and the time is that up to which all was proved.
  bool is_out_of_budget() const { return is_out_of_budget_; }

 private:
  /// Two nodes in a stretch of time.
  struct Visit {
    std::uint32_t a;
    std::uint32_t b;
    TimeCell cell;
  };

  void visit(const Visit& visit);
  void open(const Visit& visit, const MetricBox& box_a, const MetricBox& box_b, double radius_a,
            double radius_b);
  void visit_leaves(const Visit& visit);
  void decide(TrianglePair pair, TimeCell cell);
  bool is_near(TrianglePair pair, std::uint64_t time, ApartDirection& direction);
  bool are_apart(TrianglePair pair, const TimeCell& cell, const ApartDirection& direction,
                 double bulges);
  bool spend();

  MovingPair& pair_;
  bvh::TraversalStack<Visit, 256> open_;
  std::uint64_t low_;
  std::uint64_t unproved_ = ~std::uint64_t{0};  ///< where the budget ended, the first time left
  std::uint64_t budget_;
  bool is_out_of_budget_ = false;
  Work& work_;
};

}  // namespace graze
