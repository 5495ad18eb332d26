#pragma once

// Private to engine/mesh.

#include <graze/bvh/wide/front/wide_front.h>
#include <graze/engine/mesh/memory/front_costs.h>
#include <graze/engine/work.h>

#include <cstddef>
#include <optional>

namespace graze {

/// A front (bvh/wide/front/wide_front.h) that follows a motion for as long as that saves time.
class MotionFront {
 public:
  explicit MotionFront(bvh::WideFront::Kind kind) : kind_(kind) {}

  bvh::WideFront& front() { return front_; }
  /// Whether there is a front that follows the motion.
  bool is_in_use() const { return is_in_use_; }

  /// Whether this query should do without the front, because it rests for some queries; counts
  /// down.
  bool rests();

  /// Takes note that in so many queries no point of B has moved by more than the step (common
  /// units).
  void add_motion(const bvh::WideFront::MotionBound& step, int queries);

  /// The pass of this query over the front, if the front is worth it or, begun anew in these
  /// poses, promises to be. Otherwise the query should walk the trees: where most of the front is
  /// due, where queries with it have cost more than a walk, or where distances made it look at a
  /// third of the front. Then the front rests for some queries, and for more of them each time that
  /// this happens in turn. `limit` as in WideFront::update().
  std::optional<bvh::WideFront::Pass> start_pass(const bvh::WideTree& tree_a,
                                                 const bvh::WideTree& tree_b,
                                                 const bvh::RelativeFrame& b_in_a,
                                                 const bvh::RelativeFrame& a_in_b, double limit);

  /// Updates the front: looks at the pairs that are due, and adds what that took to `work`.
  void update(const bvh::WideFront::Pass& pass, double limit, Work& work);

  /// Takes note of what a query did that walked the trees to the end instead.
  void learn_walk(const Work& walk) { worth_.learn_walk(FrontWorth::cost_of_walk(walk)); }

 private:
  bool is_outgrown() const;

  /// Whether a query for a distance would compute so many distances that a walk, which sees fewer
  /// where many are nearly equal, costs less.
  bool has_many_near_pairs(const bvh::WideFront::Pass& pass, double limit);
  /// Gives the front up, and lets it rest.
  void give_up();

  /// How far ahead this update is to look for later queries.
  bvh::WideFront::Foresight foresight() const;

  /// Learns from what an update has cost whether it was worth that.
  void learn(const bvh::WideFront::Pass& pass, double cost);

  /// Gives the front a predicted motion, or takes it away where the motion deviates from it.
  void update_prediction(const bvh::RelativeFrame (&now)[2]);

  bvh::WideFront::Kind kind_;
  bvh::WideFront front_;
  bool is_in_use_ = false;
  bvh::WideFront::MotionBound motion_;  ///< since the front was begun
  int passes_ = 0;                      ///< updates since the front was begun
  std::size_t first_size_ = 0;          ///< of the front, after the first update
  int rest_ = 0;                        ///< queries until a front may be begun
  int next_rest_ = 1;
  FrontWorth worth_;
  LookAhead look_ahead_;
  double step_ = 0;      ///< how far B moved in each of the last queries, at most, on average
  int queries_ = 1;      ///< how many queries that average is over
  bool is_jump_ = true;  ///< whether the last step was far longer than those before (kJump)

  bvh::RelativeFrame last_[2] = {};  ///< the relative frames when an update was last asked for
  bvh::WideFront::MotionBound since_last_;
  bool is_last_known_ = false;
  int passes_predicted_ = 0;
  double distance_predicted_ = 0;
  double spent_at_prediction_ = 0;
  int passes_unpredicted_ = 0;  ///< updates until another prediction is tried
  int next_unpredicted_ = 1;
};

}  // namespace graze
