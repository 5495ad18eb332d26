#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/run/trial.h>

namespace graze::cli {

/// Says whose wrong answers make a replay or a comparison fail, besides those of graze.
class FailOn {
 public:
  /// Each word is `ENGINE`, `ENGINE:CLASS`, or one of these with `>SIZE`, metres, behind: then only
  /// larger errors count. An engine is one that is asked, or whose answer a case records;
  /// `recorded` is every answer that a case records. `ENGINE:changed` is no class of errors: see
  /// matches_change(). Spaces in a class may be hyphens. Throws UsageError for any other word, and
  /// for engines that are not here.
  FailOn(std::span<const std::string> words, std::span<const compare::EngineEntry> engines,
         const std::vector<std::string>& recorded_engines);

  bool is_set() const { return !rules_.empty(); }

  /// True for a wrong answer that is one of these.
  bool matches(const compare::Testimony& testimony) const;

  /// True for an answer that is known to be wrong and is one of these. `engine` may be `recorded`.
  bool matches(const std::string& engine, const compare::Judgement& judgement) const;

  /// True if `ENGINE:changed` names this engine, whose answer is another one than it was.
  bool matches_change(const std::string& engine) const;
  bool names_changes() const;

 private:
  struct Rule {
    std::string engine;
    std::optional<compare::ErrorClass> error_class;  ///< none for any class
    std::optional<double> above = {};                ///< metres; none for any size
    bool is_change = false;                          ///< true for what has changed, right or wrong
  };

  std::vector<Rule> rules_;
};

}  // namespace graze::cli
