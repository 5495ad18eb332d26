#pragma once

// Private to engine/mesh.

#include <cstddef>

namespace graze {

/// How far ahead a front looks where nothing meets: for how many queries the gap that a pass proves
/// should last. To open boxes that are apart costs time, dearly so where surfaces lie near each
/// other, and saves the passes of the queries that the gap then answers. Which pays is learned by
/// trying: a step further as long as a query costs less, back when it costs more, and what was in
/// vain is tried again later and later.
class LookAhead {
 public:
  /// 0 where it looks no further than what meets.
  double queries() const { return kQueries[level_]; }

  /// What a query has cost with this look-ahead: any unit.
  void learn(double cost);

 private:
  static constexpr int kLevels = 4;
  static constexpr double kQueries[kLevels] = {0, 2, 4, 8};

  double cost_[kLevels] = {};  // the last ones count most; 0 where nothing is known
  int level_ = 0;
  bool is_new_ = false;  // no pass has had this level since it was raised
  int hold_ = 0;         // passes until the next try
  int next_hold_ = kFirstHold;

  static constexpr int kFirstHold = 4;
  static constexpr int kLongestHold = 64;
};

}  // namespace graze
