#pragma once

// Private to engine/mesh.

#include <graze/bvh/wide/front/wide_front.h>
#include <graze/engine/work.h>

#include <cstddef>
#include <limits>

namespace graze {

/// Whether queries with a front cost less than walks, as far as is known from what both have done.
class FrontWorth {
 public:
  /// What a walk costs, and a pass, by what they count, with the pairs of primitives that a pass
  /// leaves unsure: nanoseconds on one machine, of which only ratios matter.
  static double cost_of_walk(const Work& done);
  static double cost_of_pass(const bvh::WideFront::Counts& done, std::size_t unsure);

  /// What the last query without it has cost.
  void learn_walk(double cost) { walk_ = cost; }

  /// There is another front.
  void begin() { queries_ = 0; }

  /// What a query with it has cost.
  void learn(double cost);

  /// False where queries cost more than a walk, and soon if they cost far more. True where nothing
  /// is known.
  bool is_given() const;

  /// Whether they are known to cost so much less that there is no doubt.
  bool is_sure() const;

 private:
  double walk_ = std::numeric_limits<double>::infinity();
  double mean_ = 0;  // the last ones count most
  int queries_ = 0;
};

}  // namespace graze
