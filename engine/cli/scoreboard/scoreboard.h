#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/output/output.h>
#include <graze/engine/compare/run/trial.h>

namespace graze::cli {

struct ScoreboardOptions {
  std::vector<std::string> files = {};            ///< files of cases, or folders of them
  std::string engines = {};                       ///< names with commas; empty for all
  std::vector<std::string> engine_commands = {};  ///< commands, each of which starts an engine of
                                                  ///< the user's own
  std::string markdown = {};                      ///< a file that gets a table, too
  double timeout = 60;                            ///< seconds for each question to another engine
  bool is_json = false;
  bool has_progress = false;
};

/// Says what became of one case before one engine.
enum class Score {
  Passed,   ///< the referee found all of the answer right
  Failed,   ///< wrong, or no answer at all: a crash, a hang, no number
  Refused,  ///< the engine has no such query, or does not know such shapes
  Unknown,  ///< the answer was not judged wholly, or was not wrong when it was asked again alone
};

/// Counts how an engine did in one class of cases.
using Scores = std::array<std::size_t, 4>;

/// Says who passes what: engines, and classes of cases, which are the names of files of many cases,
/// and else those of folders.
class Scoreboard {
 public:
  /// Asks the engines for their versions.
  explicit Scoreboard(std::span<const compare::EngineEntry> engines);

  void add(const std::string& kind, const std::vector<compare::Testimony>& testimonies);

  const std::vector<std::string>& engines() const { return names_; }
  bool is_graze_wrong() const;

  std::string text() const;
  /// Returns one object on one line.
  std::string json() const;
  std::string markdown() const;

 private:
  Scores total_of(std::size_t engine) const;

  std::vector<std::string> names_;
  std::vector<std::string> versions_;
  std::vector<std::string> absent_;
  std::map<std::string, std::vector<Scores>> kinds_;  ///< one for each of names_
};

/// Puts all cases to all engines. GrazeWrong if graze fails one; a case that cannot be read is
/// thrown as a CaseError, before anything is asked.
ExitCode run_scoreboard(const ScoreboardOptions& options,
                        std::span<const compare::EngineEntry> engines, Output& output);

}  // namespace graze::cli
