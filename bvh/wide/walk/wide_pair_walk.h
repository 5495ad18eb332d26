#pragma once

#include <graze/bvh/traverse/traversal.h>
#include <graze/bvh/wide/lanes/tree_transform.h>
#include <graze/bvh/wide/tree/wide_tree.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace graze::bvh {

/// Two primitives that may meet, by their places in the orders of their trees.
struct PlacePair {
  std::uint32_t a;
  std::uint32_t b;
};

/// Two primitives that surely cross, or that may meet.
struct FoundPair {
  PlacePair places;
  bool do_cross;
};

/// What a walk did.
struct WideWalkCounts {
  std::uint64_t box_tests = 0;        ///< pairs of boxes, eight at most by one kernel
  std::uint64_t box_rejections = 0;   ///< of these, found apart
  std::uint64_t primitive_tests = 0;  ///< pairs of primitives in leaves that may meet
  TreeletCounts treelets;             ///< because this walk was the first to enter them
};

/// Finds the pairs of primitives of two trees that nothing proves apart: a box of one tree
/// against the eight children of a node of the other. Hands out a few at a time and goes on where
/// it stopped, so that no callback stands in the loop. On another SIMD target it may find other
/// pairs beside those that meet, and be sure of others. The order of those that meet is the same on
/// all, but for Goal::AnyPair.
class WidePairWalk {
 public:
  /// The most pairs of two leaves, times the leaves that one query box may be near.
  static constexpr std::size_t kMostAtOnce =
      WideNode::kWidth * ChildLink::kMaxLeafSize * ChildLink::kMaxLeafSize;
  /// The most pairs that one step finds: a pair of nodes that is taken from what waits, and the
  /// children of one compared with those of the other. A walk to all pairs never stops within one,
  /// so that its order does not depend on what rounding leaves unsure.
  static constexpr std::size_t kMostInStep = WideNode::kWidth * kMostAtOnce;
  /// Room for the pairs of several steps: pairs of different leaves are decided together.
  static constexpr std::size_t kMany = kMostInStep + kMostAtOnce;

  /// What a walk looks for. Each goal has a kernel of its own.
  enum class Goal {
    AllPairs,  ///< all pairs, or the first of them in an order that is the same on all SIMD targets
    AnyPair    ///< one pair that meets, which ends the query. next() returns with what the first
               ///< leaves have that are left with any, whatever room there is. Before the 16th pair
               ///< that it compares, and then each time after twice as many, what waits longest and
               ///< what was to be next change places: a walk into a place where surfaces nearly
               ///< coincide but do not meet may be long while others meet nearby. Which pair comes
               ///< first may differ between SIMD targets
  };

  /// How tree B lies in tree A and how A lies in B, each with its slack (law 5).
  WidePairWalk(const WideTree& tree_a, const WideTree& tree_b, const RelativeFrame& b_in_a,
               const RelativeFrame& a_in_b, Goal goal);

  Goal goal() const { return goal_; }

  /// The next pairs; none when there are no more.
  std::size_t next(std::span<FoundPair> found);

  /// Two children that wait to be compared: what lies below them is a walk of its own.
  struct Waiting {
    WideChildRef a;
    WideChildRef b;
  };

  /// Appends half of what waits to `half`, nodes near the roots among them: others can walk these.
  void give_half(std::vector<Waiting>& half) {
    state_.open.take_half([&](const Waiting& waiting) { half.push_back(waiting); });
  }

  /// Whether nothing waits any more.
  bool is_over() const { return state_.open.empty(); }

  /// Adds something that waits: a part of what this walk, or one like it, was to do.
  void start_at(const Waiting& waiting) { state_.open.push(waiting); }

  /// A walk over the same trees in the same poses, with the same goal, in which nothing waits yet.
  WidePairWalk another() const { return WidePairWalk(state_.tree, state_.into, goal_); }

  /// Two of the last primitives that neither boxes nor planes told apart, if there were any: where
  /// nothing meets, they are likely to be near each other.
  const std::optional<PlacePair>& last_near() const { return state_.last_near; }

  const WideWalkCounts& counts() const { return counts_; }

  // What the kernels see.

  struct State {
    State(const WideTree& tree_a, const WideTree& tree_b, const RelativeFrame& b_in_a,
          const RelativeFrame& a_in_b)
        : tree{&tree_a, &tree_b}, into{TreeTransform(b_in_a), TreeTransform(a_in_b)} {}
    State(const WideTree* const (&trees)[2], const TreeTransform (&transforms)[2])
        : tree{trees[0], trees[1]}, into{transforms[0], transforms[1]} {}

    const WideTree* tree[2];
    TreeTransform into[2];  ///< by the side of the tested node: of query boxes of the other tree
    TraversalStack<Waiting, 192> open;
    std::optional<PlacePair> last_near;
    /// Steps from one time that a walk to any pair looks elsewhere to the next, and those that are
    /// left of them.
    std::uint32_t patience = kFirstPatience;
    std::uint32_t steps_left = kFirstPatience;
  };

 private:
  static constexpr std::uint32_t kFirstPatience = 16;

  WidePairWalk(const WideTree* const (&trees)[2], const TreeTransform (&transforms)[2], Goal goal)
      : goal_(goal), state_(trees, transforms) {}

  Goal goal_;
  State state_;
  WideWalkCounts counts_;
};

}  // namespace graze::bvh
