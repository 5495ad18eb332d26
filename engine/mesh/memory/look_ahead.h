#pragma once

// Private to engine/mesh.

#include <cstddef>

namespace graze {

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
  int hold_ = 0;         ///< how many queries remain until a higher level is tried
  int next_hold_ = kFirstHold;  ///< what hold_ becomes when a level does not pay

  static constexpr int kFirstHold = 4;
  static constexpr int kLongestHold = 64;
};

}  // namespace graze
