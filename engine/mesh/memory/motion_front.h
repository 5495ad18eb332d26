#pragma once

// Private to engine/mesh.

#include <graze/bvh/wide/front/wide_front.h>
#include <graze/engine/mesh/memory/front_reach.h>
#include <graze/engine/mesh/memory/front_worth.h>
#include <graze/engine/work.h>

#include <cstddef>
#include <optional>

namespace graze {

/// A front (bvh/wide/front/wide_front.h) that follows a motion for as long as that saves time.
class MotionFront {
 public:
  explicit MotionFront(bvh::WideFront::Bounds bounds) : bounds_(bounds) {}

  bvh::WideFront& front() { return front_; }
  bool is_live() const { return is_live_; }

  /// Whether this query had better do without it, because others have.
  bool rests();

  /// B has come so much further (common units), in so many queries.
  void move(const bvh::WideFront::MotionBound& step, int queries);

  /// The pass of this query, if the front is worth it or, begun anew in these poses, promises to
  /// be. Where most of it is due, or queries with it have cost more than a walk, or have looked at
  /// a third of it for a distance, the query had better walk the trees, and so had the next ones,
  /// the more of them the more often that happens in turn. `limit` as in WideFront::advance().
  std::optional<bvh::WideFront::Pass> pass(const bvh::WideTree& tree_a, const bvh::WideTree& tree_b,
                                           const bvh::RelativeFrame& b_in_a,
                                           const bvh::RelativeFrame& a_in_b, double limit);

  /// Looks at what is due, and counts that.
  void advance(const bvh::WideFront::Pass& pass, double limit, Work& work);

  /// A query has walked the trees instead, to the end: what that was.
  void learn_walk(const Work& walk) { worth_.learn_walk(FrontWorth::cost_of_walk(walk)); }

 private:
  bool is_outgrown() const;

  /// Of distances, each of which is computed: where many are nearly equal a walk sees fewer.
  bool has_many_candidates(const bvh::WideFront::Pass& pass, double limit);
  void pause();

  /// What this pass is to do for later queries.
  bvh::WideFront::Foresight foresight() const;

  /// What a pass that cost so much was worth.
  void learn(const bvh::WideFront::Pass& pass, double cost);

  /// Gives the front a predicted motion where there is one, and none where it would not be kept to.
  void steer(const bvh::RelativeFrame (&now)[2]);

  bvh::WideFront::Bounds bounds_;
  bvh::WideFront front_;
  bool is_live_ = false;
  bvh::WideFront::MotionBound motion_;  // since it was begun
  int passes_ = 0;                      // since it was begun
  std::size_t first_size_ = 0;          // after the first of these
  int pause_ = 0;                       // queries until it may begin
  int next_pause_ = 1;
  FrontWorth worth_;
  FrontReach reach_;
  double step_ = 0;  // of B in each of the last queries, from where it was before them
  int queries_ = 1;  // how many these are
  bool is_jump_ = true;

  bvh::RelativeFrame last_[2] = {};  // when a pass was last asked for
  bvh::WideFront::MotionBound since_last_;
  bool is_last_known_ = false;
  int passes_predicted_ = 0;
  double distance_predicted_ = 0;
  double spent_at_prediction_ = 0;
  int passes_unpredicted_ = 0;  // until another is tried
  int next_unpredicted_ = 1;
};

}  // namespace graze
