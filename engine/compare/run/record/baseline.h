#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/run/record/time_code.h>

namespace graze::compare {

/// Holds what an engine said in one pose, step or case.
struct SaidThere {
  std::string engine;
  std::string digest = {};  ///< equal for equal answers, bit for bit; empty if it gave none
  std::optional<double> value = {};  ///< the number that is the answer, if it is one
  double time = 0;                   ///< microseconds
  /// The verdict: Right also where nobody contradicted; none where a record does not say.
  std::optional<Verdict> verdict = {};
};

/// Says how what one engine said differs from what it said in an older run of the same job.
struct EngineChange {
  std::string engine;
  std::size_t compared = 0;         ///< the number of places for which both runs have an answer
  std::size_t changed = 0;          ///< how many of these changed
  std::size_t missing = 0;          ///< the number of places for which one of the two has none
  std::vector<std::size_t> places;  ///< the first places that changed
  /// The changed places by the verdicts before and now.
  std::size_t right_to_wrong = 0;
  std::size_t wrong_to_right = 0;
  std::size_t wrong_to_wrong = 0;
  /// The run took so many times as long as the older one. This is the median over the places that
  /// both have, so that neither the first answer, which builds what others find, nor one slow
  /// moment decides.
  double time_ratio = 1;
};

/// Holds a run against an older one, place by place, in memory that does not grow with them. An
/// answer has changed if one bit of it has, or, where it is a number, if that is further off than
/// `tolerance`, metres or shares of a motion.
class Baseline {
 public:
  /// At most so many places are named for each engine.
  static constexpr std::size_t kMostNamed = 20;

  explicit Baseline(double tolerance = 0) : tolerance_(tolerance) {}

  /// Adds what both say of one place; what a run does not have is empty.
  void add(std::size_t place, std::span<const SaidThere> before, std::span<const SaidThere> now);

  /// Returns the changes, graze first, the others in the order in which they were first heard.
  std::vector<EngineChange> changes() const;

 private:
  struct Held {
    EngineChange change;
    TimeMedian ratios;
  };

  Held& held(const std::string& engine);
  bool is_same(const SaidThere& before, const SaidThere& now) const;
  void compare(Held& at, std::size_t place, const SaidThere& before, const SaidThere& now) const;

  double tolerance_;
  std::vector<Held> engines_;
};

}  // namespace graze::compare
