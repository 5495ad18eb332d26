#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/compare/run/answers/answer_file.h>

namespace graze::cli {

/// Returns all engines that this command knows, and those that the commands start. Throws
/// UsageError for a command that starts none, or one whose name is taken or could be chosen by
/// nobody.
std::vector<compare::EngineEntry> engines_with(const compare::PeerSettings& settings,
                                               std::span<const std::string> commands);

/// Returns these engines and more of the command's own. Throws UsageError if an engine of the
/// user's has the name of one. The engines must outlive the result.
std::vector<compare::EngineEntry> with_more_engines(std::span<const compare::EngineEntry> engines,
                                                    std::vector<compare::EngineEntry> more);

/// Holds the engines that take part, as if there were no others.
class Field {
 public:
  /// Takes the engines of `names`, which are separated by commas; without names it takes all that
  /// are here and need not be named. graze is always among them, as it is on trial, and so are
  /// engines of the user's own. Throws UsageError for a name that is none, or of an engine that is
  /// not here. The engines must outlive this.
  Field(std::span<const compare::EngineEntry> engines, std::string_view names);

  /// Adds the recorded answers of these files, each under the name of its engine, or, where that is
  /// taken, under it with its version, "fcl@0.7.0". Throws UsageError if that is taken, too, and
  /// what read_answer_file() throws.
  void add_answers(std::span<const std::string> files, const compare::AnswersWanted& wanted);

  std::span<const compare::EngineEntry> engines() const { return engines_; }

 private:
  std::vector<compare::EngineEntry> engines_;
};

}  // namespace graze::cli
