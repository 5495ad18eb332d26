#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <graze/engine/cli/replay/fail_on.h>
#include <graze/engine/compare/run/shrink_worst.h>

namespace graze::cli {

/// Takes wrong answers of a run as they come, however many. They are counted, and those that are
/// told one by one are kept: the first, the worst, and the first answers of each engine that close
/// the gate.
class WrongList {
 public:
  /// This many of the first are kept, and this many of each engine.
  static constexpr std::size_t kFirst = 200;
  static constexpr std::size_t kFirstOfEngine = 20;
  static constexpr std::size_t kFirstOfClass = 8;  ///< the number kept of each class of each engine

  /// Keeps `keep` of the worst, for engines of which cases can be made. Every wrong answer of graze
  /// closes the gate, and those that `fail_on` names.
  WrongList(std::size_t keep, FailOn fail_on, std::set<std::string> have_cases);

  void add(compare::WrongAnswer wrong);

  std::size_t count() const { return count_; }

  /// Returns those that are kept, in the order in which they came. The first kFirst of all are the
  /// first ones.
  std::vector<compare::WrongAnswer> kept() const;

  /// Returns the first of an engine that have this class.
  std::span<const compare::WrongAnswer> examples(const std::string& engine,
                                                 compare::ErrorClass error_class) const;

  /// Says how many answers of an engine close the gate, by their class, and which are the first of
  /// them.
  struct Closing {
    std::size_t count = 0;
    std::array<std::size_t, compare::kErrorClasses.size()> classes{};
    std::vector<compare::WrongAnswer> first = {};
  };
  const Closing& closing(const std::string& engine) const;
  bool closes_gate() const { return !closing_.empty(); }
  std::size_t named_by_fail_on() const { return named_; }
  const FailOn& fail_on() const { return fail_on_; }

 private:
  void keep_if_worst(std::size_t number, const compare::WrongAnswer& wrong);

  std::size_t keep_;
  FailOn fail_on_;
  std::set<std::string> have_cases_;
  std::size_t count_ = 0;
  std::size_t named_ = 0;
  std::map<std::size_t, compare::WrongAnswer> first_;  ///< answers by the number in which they came
  std::vector<std::pair<std::size_t, compare::WrongAnswer>> worst_;  ///< a heap, the least on top
  std::map<std::string, Closing> closing_;
  std::map<std::pair<std::string, compare::ErrorClass>, std::vector<compare::WrongAnswer>>
      examples_;
};

}  // namespace graze::cli
