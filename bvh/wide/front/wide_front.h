#pragma once

#include <graze/bvh/tree/box_separation.h>
#include <graze/bvh/wide/front/front_planes.h>
#include <graze/bvh/wide/front/motion_prediction.h>
#include <graze/bvh/wide/lanes/wide_way.h>
#include <graze/bvh/wide/tree/wide_tree.h>
#include <graze/bvh/wide/walk/wide_pair_walk.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace graze::bvh {

/// Where a walk over two trees ended, kept for the next pose of a motion: the pairs of a box and
/// the children of a node, the pairs of leaves, and the pairs of primitives that it looked at. Each
/// has a budget: how far B may have moved, as measured from begin() on, until what keeps it out
/// could be gone, and planes that kept it out. A pass looks only at what is due and no longer kept
/// out, and opens what has come near. What was opened stays so until begin(), so that the front
/// grows. Leaves in which primitives meet are busy: each pass decides all their pairs anew.
///
/// All lengths are in the common units of both trees. Motions add up: no point of B's box has come
/// further in A's frame than their sum.
class WideFront {
 public:
  using Bounds = FrontBounds;

  /// What `moved`, limits and reaches must stay below.
  static constexpr double kFarthest = 0x1p60;

  /// How B has moved in A since begin(): no point of B's box came further than `way`, and the
  /// changes of its rotation, as lengths of nine numbers, add up to no more than `turn`.
  struct Motion {
    double way = 0;
    double turn = 0;
  };

  /// The poses of a query, and what it asks: from pass().
  struct Pass {
    /// As in WideDistanceWalk.
    void aim_along(const double (&direction)[3]);

    Bounds bounds;
    double moved = 0;
    double slack;  // of both
    WideWay into[2];
    float units[2];              // of each tree, in common units
    float direction[2][3] = {};  // in each tree's frame, from it to the other
    FrontWay since[2];           // of query boxes of the other tree, since begin()
    float deviation = 1;         // kDrift on a predicted motion, whose are
    FrontWay step[2];            // how query boxes of the other tree go on,
    float per_way = 0;           // each time that B comes so far

   private:
    friend class WideFront;
    Pass(const RelativeFrame& b_in_a, const RelativeFrame& a_in_b, Bounds bounds);
  };

  /// Forgets everything and begins with the roots, which must outlive it, in these poses: how tree
  /// B lies in tree A and how A lies in B, each with its slack (law 5), in the same common units.
  void begin(const WideTree& tree_a, const WideTree& tree_b, const RelativeFrame& b_in_a,
             const RelativeFrame& a_in_b);

  /// The same trees are in other poses, in the same units, since begin() after this motion.
  void follow(const RelativeFrame& b_in_a, const RelativeFrame& a_in_b, const Motion& motion);

  /// In the poses that it followed to.
  Pass pass(Bounds bounds) const;

  /// From here on B is expected to go on as it came from these poses, a `step` ago. What it does
  /// not come nearer to is then due later. Other motions are no less certain, but cost time.
  void set_prediction(const RelativeFrame (&before)[2], const Motion& step);
  void drop_prediction();
  bool has_prediction() const { return has_prediction_; }
  /// What budgets are compared with: how far B has come, or more.
  double spent() const { return spent_; }

  /// The share of all that is due in this pass.
  double share_due(const Pass& pass, double limit) const;

  /// What a pass does for later ones, so that the gap that it proves is larger: it opens boxes that
  /// are no further apart than `reach` as if they met, until the front holds so much more, and
  /// looks again at primitives as near. But not where primitives are no further apart than
  /// `useful`, which a gap has to exceed to be worth anything. Common units.
  struct Foresight {
    double reach = 0;
    double useful = 0;
    std::size_t most_added = 0;
  };

  /// Looks at all boxes and leaves that are due. Afterwards no two primitives are `limit` apart or
  /// nearer but, by Bounds::Distance, those that are candidates, and by Bounds::Meeting, whose
  /// limit is 0, those that surely cross, crossing(), and some of those that may meet, unsure().
  void advance(const Pass& pass, double limit, const Foresight& foresight);

  std::size_t crossing_count() const { return state_.crossing.size; }
  PlacePair crossing(std::size_t index) const { return places_of(state_.crossing.lanes[index]); }
  std::size_t unsure_count() const { return state_.unsure.size; }
  PlacePair unsure(std::size_t index) const { return places_of(state_.unsure.lanes[index]); }

  /// How many of the boxes and leaves that it held the last pass had to look at.
  std::size_t looked_at() const { return state_.looked_at; }

  std::size_t candidate_count() const { return state_.candidates.size(); }
  PlacePair candidate(std::size_t index) const { return places_of(state_.candidates[index]); }

  /// Whether a candidate may be `limit` apart or nearer, after what was said of it.
  bool is_due(std::size_t index, const Pass& pass, double limit);

  /// Candidate `index` is at least so far apart in this pass (common units).
  void set_gap(std::size_t index, const Pass& pass, double gap);

  /// How far two primitives are apart at least along a direction, from A to B, which is no longer
  /// than 1 in the frame of either tree (common units).
  struct Gap {
    double units;
    double along_in_a[3];
    double along_in_b[3];
  };

  /// Candidate `index` is apart by that in this pass, and while it is it is not due.
  void keep_apart(std::size_t index, const Pass& pass, const Gap& gap);

  /// How far apart all is at least, if no candidate was near and nothing met: valid after
  /// advance().
  double proven_gap(const Pass& pass) const;

  /// What it holds: pairs that were looked at.
  std::size_t size() const {
    return state_.visits.size() + state_.leaves.size() + state_.candidates.size();
  }

  /// Of all passes since begin(); pairs of boxes that were not due are `skipped`.
  struct Counts {
    WideWalkCounts walk;
    std::uint64_t skipped = 0;
  };
  Counts take_counts();

  // What the kernels see.

  /// A box beside the children of a node: of which of these something further down is in the front.
  struct Visit {
    WideChildRef tested;  // the first child
    WideChildRef query;
    int tested_side;
    float tested_size;  // of the box around the children
    std::uint32_t open;
  };

  /// A leaf, by its treelet.
  struct Leaf {
    std::uint32_t treelet;
    std::uint32_t link;
    std::uint32_t first;  // place of a primitive
    float size;           // which no two of its corners are further apart than
    bool operator==(const Leaf&) const = default;
  };

  /// Two leaves.
  struct Leaves {
    Leaf tested;
    Leaf query;
    int tested_side;
    std::uint32_t listed;  // which pairs are candidates: rows are of the tested node's primitives
  };

  static constexpr std::size_t kLeafPairs = ChildLink::kMaxLeafSize * ChildLink::kMaxLeafSize;

  /// Pairs of primitives, as 16 times a pair of leaves and a lane of these.
  struct LeafPairs {
    std::vector<std::uint32_t> lanes;  // with room for one vector more
    std::size_t size = 0;

    void make_room(std::size_t leaves) {
      const std::size_t needed = size + kLeafPairs * (leaves + 1);
      if (lanes.size() < needed) lanes.resize(2 * needed);
    }
    bool empty() const { return size == 0; }
  };

  /// One for each visit, and each two leaves.
  template <FrontBounds bounds>
  struct Planes {
    std::vector<FrontPlanes<WideNode::kWidth, bounds>> of_visits;
    std::vector<FrontPlanes<kLeafPairs, bounds>> of_leaves;

    void clear() {
      of_visits.clear();
      of_leaves.clear();
    }
  };

  struct State {
    const WideTree* tree[2] = {nullptr, nullptr};
    std::vector<Visit> visits;
    Planes<FrontBounds::Meeting> meeting;    // of passes with these bounds,
    Planes<FrontBounds::Distance> distance;  // or these
    std::vector<float> visit_budgets;
    std::vector<Leaves> leaves;
    std::vector<float> leaves_budgets;
    std::vector<std::uint32_t> busy;  // of these leaves
    LeafPairs crossing;
    LeafPairs unsure;
    std::vector<std::uint32_t> candidates;  // as those of LeafPairs
    std::vector<float> candidate_budgets;
    std::vector<FrontPlane> candidate_planes;
    std::vector<std::uint32_t> due;  // what a pass looks at
    std::size_t looked_at = 0;       // in the last pass, of what there was
    float least_budget = 0;          // of visits and leaves, where none is busy
    std::uint64_t lanes = 0;         // of all visits
    WideWalkCounts counts;
  };

 private:
  PlacePair places_of(std::uint32_t lane_of_leaves) const;

  State state_;
  RelativeFrame first_[2] = {};  // at begin()
  RelativeFrame last_[2] = {};   // when a pass was last asked for
  Motion motion_;                // until then, since begin()
  double spent_ = 0;  // what budgets are compared with: the way, or more (motion_prediction.h)
  bool has_prediction_ = false;
  MotionPrediction prediction_;
  std::uint64_t skipped_ = 0;
};

}  // namespace graze::bvh
