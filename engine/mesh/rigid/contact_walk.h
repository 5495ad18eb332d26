#pragma once

// This is private to engine/mesh/rigid.

#include <graze/bvh/traverse/traversal.h>
#include <graze/engine/mesh/rigid/freedom_record.h>
#include <graze/engine/mesh/rigid/moving_pair.h>
#include <graze/engine/mesh/triangle_pairs.h>
#include <graze/engine/work.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace graze {

/// Walks pairs of nodes, each with a stretch of time of its own, and looks for the first time of
/// the grid at which two triangles are as near as the limit.
class ContactWalk {
 public:
  /// Says when a walk ends: at any such time, or when it knows the first.
  enum class End { AtAny, AtFirst };

  ContactWalk(MovingPair& pair, End end, std::uint64_t budget, Work& work)
      : pair_(pair),
        end_(end),
        low_(pair.grid().end()),
        budget_(budget),
        boxes_a_(pair.a()),
        boxes_b_(pair.b()),
        work_(work) {}

  /// Lets the walk tell each of its steps to `record`, which outlives it.
  void record_in(FreedomRecord& record) { record_ = &record; }

  /// Returns such a time. It is the end of the grid if there is none: then all is further apart at
  /// all times.
  std::uint64_t run();

  /// True if the budget ended first, so that the time is that up to which all was proved.
  bool is_out_of_budget() const { return is_out_of_budget_; }

 private:
  /// Two nodes in a stretch of time.
  struct Visit {
    std::uint32_t a;
    std::uint32_t b;
    TimeCell cell;
    bool has_direction;  ///< whether there is a direction that may keep them apart
    ApartDirection direction;
  };

  /// Two triangles in one cell of time, and what kept them apart before and after.
  struct DirectedCell {
    TimeCell cell;
    bool has_direction;
    ApartDirection direction;
  };

  void visit(const Visit& visit);
  void open(const Visit& visit, const TimeSpan& span, const BodyBox& box_a, const BodyBox& box_b);
  /// True if two nodes are opened at once: boxes of much the same size.
  bool are_both_opened(const bvh::Node& a, const bvh::Node& b, double size_a, double size_b) const;
  void visit_leaves(const Visit& visit);
  void decide(TrianglePair of_bodies, const DirectedCell& whole);
  void find_near(std::uint64_t time);

  /// Keeps the last boxes of nodes of one body: most visits come upon one that was there just
  /// before.
  class RecentBoxes {
   public:
    explicit RecentBoxes(const MovingBody& body) : body_(body) { nodes_.fill(kNone); }
    /// Returns the box of a node, valid until the next call.
    const BodyBox& of(std::uint32_t node) {
      const std::size_t place = node % kPlaces;
      if (nodes_[place] != node) {
        nodes_[place] = node;
        boxes_[place] = body_.box(node);
      }
      return boxes_[place];
    }

   private:
    static constexpr std::size_t kPlaces = 64;
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    const MovingBody& body_;
    std::array<std::uint32_t, kPlaces> nodes_;
    std::array<BodyBox, kPlaces> boxes_;
  };

  /// Returns the part of a cell that is still to be proved.
  TimeSpan before_low(const TimeCell& cell) const;

  /// Spends one test of the budget. Returns false if there is none.
  bool spend();

  MovingPair& pair_;
  End end_;
  bool is_narrowed_ = false;
  bvh::TraversalStack<Visit, 256> open_;
  std::uint64_t low_;
  std::uint64_t unproved_ = ~std::uint64_t{0};  ///< the first time left where the budget ended
  std::uint64_t budget_;
  bool is_out_of_budget_ = false;
  FreedomRecord* record_ = nullptr;
  RecentBoxes boxes_a_;
  RecentBoxes boxes_b_;
  Work& work_;
};

}  // namespace graze
