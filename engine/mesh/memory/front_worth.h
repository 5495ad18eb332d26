#pragma once

// Private to engine/mesh.

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

  /// False where queries with the front cost more than a walk: after a few queries, or at once if
  /// they cost far more. True where nothing is known.
  bool is_given() const;

  /// True if it is known that they cost far less than a walk.
  bool is_sure() const;

 private:
  double walk_ = std::numeric_limits<double>::infinity();
  double mean_ = 0;  ///< of the costs with the front; the last ones count most
  int queries_ = 0;
};

}  // namespace graze
