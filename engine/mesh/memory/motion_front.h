#pragma once

// This keeps a front for as long as it saves time. What queries with it have cost so far decides
// whether it is worth it, and how far it had better look ahead. It is private to engine/mesh.

#include <graze/bvh/wide/front/wide_front.h>
#include <graze/engine/work.h>

#include <cstddef>
#include <limits>
#include <optional>

namespace graze {

/// Decides whether queries with a front cost less than walks over the trees, by the counters of
/// both.
class FrontWorth {
 public:
  /// Return what a walk, or an update of the front, costs by its counters; `unsure` are the pairs
  /// of primitives that the update leaves unsure. The unit is the nanosecond of one machine: only
  /// ratios matter.
  static double cost_of_walk(const Work& done);
  static double cost_of_pass(const bvh::WideFront::Counts& done, std::size_t unsure);

  /// Takes note of what the last query without a front has cost.
  void learn_walk(double cost) { walk_ = cost; }

  /// Forgets what the front before has cost.
  void begin() { queries_ = 0; }

  /// Takes note of what a query with the front has cost.
  void learn(double cost);

  /// True if the front is worth it, or if nothing is known. It is not where queries with it cost
  /// more than a walk: after a few queries, or at once if they cost far more.
  bool is_worth_it() const;

  /// True if it is known that they cost far less than a walk.
  bool is_surely_worth_it() const;

 private:
  double walk_ = std::numeric_limits<double>::infinity();
  double mean_ = 0;  ///< the mean of the costs with the front; the last ones count most
  int queries_ = 0;
};

/// Chooses the look-ahead of a front where nothing meets: for how many queries the gap that a pass
/// proves should last. A longer one opens more boxes that are apart, which costs time, above all
/// where surfaces lie near each other; and it saves the passes of the queries that the gap then
/// answers. It learns by trying: one level more as long as a query costs less, one less when it
/// costs more. A level that did not pay is tried again later, and each time after a longer wait.
class LookAhead {
 public:
  /// Returns how many queries to look ahead; 0 where only what meets is looked at.
  double queries() const { return kQueries[level_]; }

  /// Takes note of what a query has cost with this look-ahead, in any unit.
  void learn(double cost);

 private:
  static constexpr int kLevels = 4;
  static constexpr double kQueries[kLevels] = {0, 2, 4, 8};

  double cost_[kLevels] =
      {};  ///< the cost of each level, a mean in which the last queries count most; 0 if unknown
  int level_ = 0;
  bool is_new_ = false;  ///< whether the level was raised and no query has been made with it yet
  int wait_ = 0;         ///< how many queries remain until a higher level is tried
  int next_wait_ = kFirstWait;  ///< what wait_ becomes when a level does not pay

  static constexpr int kFirstWait = 4;
  static constexpr int kLongestWait = 64;
};

/// A front (bvh/wide/front/wide_front.h) that follows a motion for as long as that saves time.
class MotionFront {
 public:
  explicit MotionFront(bvh::WideFront::Kind kind) : kind_(kind) {}

  bvh::WideFront& front() { return front_; }
  /// True if there is a front that follows the motion.
  bool is_in_use() const { return is_in_use_; }

  /// True if this query should do without the front, because that rests for some queries. Then it
  /// counts as one of these.
  bool use_up_rest();

  /// Takes note that in so many queries no point of B has moved by more than the step (common
  /// units).
  void add_motion(const bvh::WideFront::MotionBound& step, int queries);

  /// Returns the pass of this query over the front, if the front is worth it or, begun anew in
  /// these poses, promises to be. Otherwise it returns nothing, and the query should walk the
  /// trees: where most budgets of the front are spent after a jump, where too many near pairs are
  /// due, where queries with it have cost more than a walk, or where distances made it look at a
  /// third of the front. Then the front rests for some queries, and for more of them each time that
  /// this happens in turn. `limit` is as in WideFront::update().
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

  /// True if a query for a distance would compute so many distances that a walk, which sees fewer
  /// where many are nearly equal, costs less.
  bool has_many_near_pairs(const bvh::WideFront::Pass& pass, double limit);
  /// Gives the front up, and lets it rest.
  void give_up();

  /// Returns how far ahead this update is to look for later queries.
  bvh::WideFront::Foresight foresight() const;

  /// Learns from what an update has cost whether it was worth that.
  void learn(const bvh::WideFront::Pass& pass, double cost);

  /// Gives the front a predicted motion, or takes it away where the motion deviates from it.
  void update_prediction(const bvh::RelativeFrame (&now)[2]);

  bvh::WideFront::Kind kind_;
  bvh::WideFront front_;
  bool is_in_use_ = false;
  bvh::WideFront::MotionBound motion_;  ///< the motion since the front was begun
  int passes_ = 0;                      ///< updates since the front was begun
  std::size_t first_size_ = 0;          ///< the size of the front after the first update
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
