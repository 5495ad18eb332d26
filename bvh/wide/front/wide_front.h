#pragma once

#include <graze/bvh/tree/box_separation.h>
#include <graze/bvh/wide/front/front_planes.h>
#include <graze/bvh/wide/lanes/tree_transform.h>
#include <graze/bvh/wide/tree/wide_tree.h>
#include <graze/bvh/wide/walk/wide_pair_walk.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace graze::bvh {

/// Keeps the front of the bounding volume test tree of two trees, which is where its first pass,
/// from both roots, ended, for the next poses of a motion: front tracking (Li and Chen,
/// "Incremental 3D collision detection with hierarchical data structures", 1998; Ehmann and Lin,
/// "Accurate and fast proximity queries between polyhedra using convex surface decomposition",
/// 2001; Tang, Manocha, Lin and Tong, "Collision-streams: fast GPU-based collision detection for
/// deformable models", 2011).
///
/// It holds the pairs of a query box and the children of a tested node, and the pairs of leaves.
/// Each has planes that kept it out, and a budget: so much motion, measured from begin() on, cannot
/// make these planes fail. A front of distances gives near pairs of primitives a plane and a budget
/// of their own. Planes and budgets are the certificates and failure times of a kinetic data
/// structure (Basch, Guibas and Hershberger, "Data structures for mobile data", 1999), with bounds
/// of motion in place of known motions. A pass looks only at pairs whose budget is spent and that
/// no plane keeps out any more, and opens what has come near. What was opened stays so until
/// begin(), so that the front grows. Leaves in which primitives meet, or are parted by no plane,
/// are busy: each pass decides all their pairs anew.
///
/// All lengths are in the common units of both trees. Motions add up: no point of B's box has come
/// further in A's frame than their sum.
class WideFront {
 public:
  using Kind = FrontKind;

  /// The motion spent, limits and look-aheads must stay below this.
  static constexpr double kFarthest = 0x1p60;

  /// Bounds of how B has moved in A since begin(): no point of B's box came further than
  /// `distance`, and the changes of its rotation, as Frobenius norms, add up to no more
  /// than `rotation_change`.
  struct MotionBound {
    double distance = 0;
    double rotation_change = 0;
  };

  /// The poses of a query, and what it asks. start_pass() makes it.
  struct Pass {
    /// Lets the pass look also for gaps along this direction, from A to B in the frame of A.
    void aim_along(const double (&direction)[3]);

    Kind kind;              ///< what the pass is to prove
    double spent = 0;       ///< the motion spent
    double slack;           ///< the slack of both frames
    TreeTransform into[2];  ///< for each side of the tested node, the transform of query boxes of
                            ///< the other tree
    float units[2];         ///< the units of each tree, in common units
    float direction[2][3] = {};      ///< the direction in each tree's frame, from it to the other
    QueryDisplacement since[2];      ///< the displacement of query boxes of the other tree since
                                     ///< begin()
    float deviation = 1;             ///< kDeviation if a motion is predicted, else 1
    QueryDisplacement predicted[2];  ///< the displacement that query boxes of the other tree are
                                     ///< predicted to repeat
    float per_distance = 0;          ///< 1 over how far B comes with that displacement

   private:
    friend class WideFront;
    Pass(const RelativeFrame& b_in_a, const RelativeFrame& a_in_b, Kind kind);
  };

  /// Forgets everything and begins with the roots of trees, which must outlive the front, in these
  /// poses: how tree B lies in tree A and how A lies in B, each with its slack (law 5), in the same
  /// common units.
  void begin(const WideTree& tree_a, const WideTree& tree_b, const RelativeFrame& b_in_a,
             const RelativeFrame& a_in_b);

  /// Takes over other poses of the same trees, in the same units, to which `motion` has led since
  /// begin(), and adds to the motion spent how much it has grown.
  void move_to(const RelativeFrame& b_in_a, const RelativeFrame& a_in_b, const MotionBound& motion);

  /// Returns a pass in the poses that were set last.
  Pass start_pass(Kind kind) const;

  /// Predicts that B goes on from here as it came from the poses `before`, a `step` ago. Pairs that
  /// the predicted motion does not bring nearer are then due later. If B moves otherwise, answers
  /// are as certain as before, but take more time.
  void set_prediction(const RelativeFrame (&before)[2], const MotionBound& step);
  void drop_prediction();
  bool has_prediction() const { return has_prediction_; }
  /// Returns the motion spent, with which budgets are compared: how far B has come, or more.
  double spent() const { return spent_; }

  /// Returns the share of all visits and leaves whose budget is spent in this pass. At most so many
  /// of them are due, for planes may still keep some of them apart.
  double share_spent(const Pass& pass, double limit) const;

  /// Says what a pass does for later ones, so that the gap that it proves is larger. It opens boxes
  /// that are no further apart than `look_ahead` as if they met, until the front holds `most_added`
  /// pairs more, and compares primitives that are as near. It does not where primitives are no
  /// further apart than `useful`, which a gap has to exceed to be worth anything. Lengths are in
  /// common units.
  struct Foresight {
    double look_ahead = 0;
    double useful = 0;
    std::size_t most_added = 0;
  };

  /// Renews the budgets of boxes and leaves whose planes still keep them apart, and looks at all
  /// others whose budget is spent: these are due. Afterwards all primitives that are no further
  /// apart than `limit` are listed: in a front of Kind::Distance by near_pair(), in one of
  /// Kind::Intersection, whose limit is 0, by crossing() if they surely cross and else by unsure(),
  /// which may list others, too.
  void update(const Pass& pass, double limit, const Foresight& foresight);

  std::size_t crossing_count() const { return state_.crossing.size; }
  PlacePair crossing(std::size_t index) const { return places_of(state_.crossing.lanes[index]); }
  std::size_t unsure_count() const { return state_.unsure.size; }
  PlacePair unsure(std::size_t index) const { return places_of(state_.unsure.lanes[index]); }

  /// Returns how many of the boxes and leaves that the front held the last pass had to look at.
  std::size_t looked_at() const { return state_.looked_at; }

  std::size_t near_pair_count() const { return state_.near_pairs.size(); }
  PlacePair near_pair(std::size_t index) const { return places_of(state_.near_pairs[index]); }

  /// True if a near pair is further apart than `limit`, by what set_gap() and keep_apart() proved.
  /// If the budget of that pair is spent, but not the gap along its plane, it gets a later budget.
  bool renew_budget(std::size_t index, const Pass& pass, double limit);

  /// Notes that near pair `index` is at least so far apart in this pass (common units): that is its
  /// budget.
  void set_gap(std::size_t index, const Pass& pass, double gap);

  /// A lower bound of how far two primitives are apart along a direction, common units.
  struct Gap {
    double units;
    double along_in_a[3];  ///< the direction from A to B in the frame of A, no longer than 1
    double along_in_b[3];  ///< the same in the frame of B
  };

  /// Notes that near pair `index` is apart by that gap in this pass, and keeps the plane across its
  /// direction, by which renew_budget() tells how far apart the pair is in later poses.
  void keep_apart(std::size_t index, const Pass& pass, const Gap& gap);

  /// Returns how far apart all is at least, if no near pair was within the limit and nothing met.
  /// It is valid after update().
  double proven_gap(const Pass& pass) const;

  /// Returns how many pairs that were looked at the front holds.
  std::size_t size() const {
    return state_.visits.size() + state_.leaves.size() + state_.near_pairs.size();
  }

  /// Counts what all passes did since these counts were last taken. Pairs of boxes that were not
  /// due are `skipped`.
  struct Counts {
    WideWalkCounts walk;
    std::uint64_t skipped = 0;
  };
  Counts take_counts();

  // The kernels see the following.

  /// A query box beside the children of a tested node.
  struct Visit {
    WideChildRef tested;  ///< the first child
    WideChildRef query;
    int tested_side;
    float tested_size;     ///< the size of the box around the children
    std::uint32_t opened;  ///< the children below which the front goes on
  };

  /// A leaf, by its treelet.
  struct Leaf {
    std::uint32_t treelet;
    std::uint32_t link;
    std::uint32_t first;  ///< the place of its first primitive
    float size;           ///< the largest distance of two of its corners, or more
    bool operator==(const Leaf&) const = default;
  };

  /// Two leaves beside each other.
  struct Leaves {
    Leaf tested;
    Leaf query;
    int tested_side;
    std::uint32_t listed;  ///< the near pairs among their primitives, by their lanes
  };

  static constexpr std::size_t kLeafPairs = ChildLink::kMaxLeafSize * ChildLink::kMaxLeafSize;

  /// Pairs of primitives, each as 16 times a pair of leaves and a lane of these.
  struct LeafPairs {
    std::vector<std::uint32_t> lanes;  ///< the pairs, with room for one vector more
    std::size_t size = 0;

    void make_room(std::size_t leaves) {
      const std::size_t needed = size + kLeafPairs * (leaves + 1);
      if (lanes.size() < needed) lanes.resize(2 * needed);
    }
    bool empty() const { return size == 0; }
  };

  /// The planes of each visit, and of each pair of leaves.
  template <FrontKind kind>
  struct Planes {
    std::vector<FrontPlanes<WideNode::kWidth, kind>> of_visits;
    std::vector<FrontPlanes<kLeafPairs, kind>> of_leaves;

    void clear() {
      of_visits.clear();
      of_leaves.clear();
    }
  };

  struct State {
    const WideTree* tree[2] = {nullptr, nullptr};
    std::vector<Visit> visits;
    Planes<FrontKind::Intersection> intersection;  ///< planes of a front of this kind
    Planes<FrontKind::Distance> distance;          ///< planes of a front of this kind
    std::vector<float> visit_budgets;
    std::vector<Leaves> leaves;
    std::vector<float> leaves_budgets;
    std::vector<std::uint32_t> busy;  ///< indices of `leaves` in which primitives meet or may meet
    LeafPairs crossing;
    LeafPairs unsure;
    std::vector<std::uint32_t> near_pairs;  ///< near pairs, as the lanes of LeafPairs
    std::vector<float> near_pair_budgets;
    std::vector<FrontPlane> near_pair_planes;
    std::vector<std::uint32_t>
        due;                    ///< working memory: indices of what is spent, then of what is due
    std::size_t looked_at = 0;  ///< how many the last pass looked at, of those that were there
                                ///< before it
    float least_budget = 0;     ///< the least budget of visits and leaves, if none is busy
    std::uint64_t lanes = 0;    ///< the number of lanes of all visits
    WideWalkCounts counts;
  };

 private:
  PlacePair places_of(std::uint32_t lane_of_leaves) const;

  State state_;
  RelativeFrame first_[2] = {};  ///< the frames at begin()
  RelativeFrame last_[2] = {};   ///< the frames at the last move_to()
  MotionBound motion_;           ///< the motion from begin() to the last move_to()
  double spent_ = 0;             ///< the motion spent (front_planes.h)
  bool has_prediction_ = false;
  MotionPrediction prediction_;
  std::uint64_t skipped_ = 0;
};

// What the kernels are called with.

/// Pairs that are further apart than `limit` and whose budget is more than `spent_budget` are
/// skipped. The budgets of the others are spent; those of them that no plane keeps out any more are
/// due.
struct FrontHorizon {
  float limit;         ///< common units
  float spent_budget;  ///< the largest budget that counts as spent: the motion spent, with slacks
                       ///< and the limit
};

/// Says what an update of a front looks at.
struct FrontTask {
  FrontHorizon required;    ///< the pairs that it has to compare
  FrontHorizon look_ahead;  ///< the pairs that it may compare for later passes, as in
                            ///< WideFront::Foresight
  float useful;             ///< as in WideFront::Foresight
  std::size_t most_added;   ///< as in WideFront::Foresight
};

/// Looks at what is due in a front, and at what is busy. It is private to bvh/wide.
void update_front(WideFront::State& state, const WideFront::Pass& pass, const FrontTask& task);

}  // namespace graze::bvh
