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

/// Wrong answers of a run as they come, however many: they are counted, and those are kept that are
/// told one by one: the first, the worst, and the first of each engine that close the gate.
class WrongList {
 public:
  /// So many of the first are kept, and so many of each engine.
  static constexpr std::size_t kFirst = 200;
  static constexpr std::size_t kFirstOfEngine = 20;
  static constexpr std::size_t kFirstOfClass = 8;  ///< and of each class of each engine

  /// `keep` of the worst are kept, of engines of which cases can be made. Every wrong answer of
  /// graze closes the gate, and those that `fail_on` names.
  WrongList(std::size_t keep, FailOn fail_on, std::set<std::string> have_cases);

  void add(compare::WrongAnswer wrong);

  std::size_t count() const { return count_; }

  /// Those that are kept, in the order in which they came. The first kFirst of all are the first
  /// ones.
  std::vector<compare::WrongAnswer> kept() const;

  /// The first of an engine that have this class.
  std::span<const compare::WrongAnswer> examples(const std::string& engine,
                                                 compare::ErrorClass error_class) const;

  /// How many of an engine close the gate, by their class, and the first of them.
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
  std::map<std::size_t, compare::WrongAnswer> first_;  ///< by the number in which they came
  std::vector<std::pair<std::size_t, compare::WrongAnswer>> worst_;  ///< a heap, the least on top
  std::map<std::string, Closing> closing_;
  std::map<std::pair<std::string, compare::ErrorClass>, std::vector<compare::WrongAnswer>>
      examples_;
};

}  // namespace graze::cli
