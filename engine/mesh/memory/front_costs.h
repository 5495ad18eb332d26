#pragma once

// What queries with a front have cost so far, and what follows: whether the front is worth it, and
// how far it had better look ahead. Private to engine/mesh.

#include <graze/bvh/wide/front/wide_front.h>
#include <graze/engine/work.h>

#include <cstddef>
#include <limits>

namespace graze {

/// Whether queries with a front cost less than walks over the trees, judged by the counters of
/// both.
class FrontWorth {
 public:
  /// What a walk, or an update of the front, costs by its counters; `unsure` are the pairs of
  /// primitives that the update leaves unsure. In nanoseconds of one machine: only ratios matter.
  static double cost_of_walk(const Work& done);
  static double cost_of_pass(const bvh::WideFront::Counts& done, std::size_t unsure);

  /// Takes note of what the last query without a front has cost.
  void learn_walk(double cost) { walk_ = cost; }

  /// Forgets what the front before has cost.
  void begin() { queries_ = 0; }

  /// Takes note of what a query with the front has cost.
  void learn(double cost);

  /// Whether the front is worth it. Not where queries with it cost more than a walk: after a few
  /// queries, or at once if they cost far more. True where nothing is known.
  bool is_worth_it() const;

  /// Whether it is known that they cost far less than a walk.
  bool is_surely_worth_it() const;

 private:
  double walk_ = std::numeric_limits<double>::infinity();
  double mean_ = 0;  ///< of the costs with the front; the last ones count most
  int queries_ = 0;
};

/// The look-ahead of a front where nothing meets: for how many queries the gap that a pass proves
/// should last. A longer one opens more boxes that are apart, which costs time, above all where
/// surfaces lie near each other; and it saves the passes of the queries that the gap then answers.
/// What pays is learned by trying: one level more as long as a query costs less, one less when it
/// costs more. A level that did not pay is tried again later, and each time after a longer wait.
class LookAhead {
 public:
  /// How many queries ahead; 0 where only what meets is looked at.
  double queries() const { return kQueries[level_]; }

  /// Takes note of what a query has cost with this look-ahead, in any unit.
  void learn(double cost);

 private:
  static constexpr int kLevels = 4;
  static constexpr double kQueries[kLevels] = {0, 2, 4, 8};

  double cost_[kLevels] =
      {};  ///< of each level, a mean in which the last queries count most; 0: unknown
  int level_ = 0;
  bool is_new_ = false;  ///< whether the level was raised and no query has been made with it yet
  int wait_ = 0;         ///< how many queries remain until a higher level is tried
  int next_wait_ = kFirstWait;  ///< what wait_ becomes when a level does not pay

  static constexpr int kFirstWait = 4;
  static constexpr int kLongestWait = 64;
};

}  // namespace graze
