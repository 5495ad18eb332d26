#include <graze/engine/cli/commands/commands.h>
#include <graze/engine/cli/compare/engine_field.h>
#include <graze/engine/cli/files/output_places.h>
#include <graze/engine/cli/output/count_argument.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/scoreboard/hard_case.h>
#include <graze/engine/cli/scoreboard/scoreboard.h>

#include <CLI/CLI.hpp>
#include <memory>

namespace graze::cli {
namespace {

constexpr const char* kScoreboardFooter = R"(
A row for each class of cases (a file .jsonl of many, or a folder), and a column for each engine: how many it passes,
which the referee found wholly right; then how many failed (wrong, a crash, a hang, no number), were refused (no such
query, no such shapes), and are unknown (not wholly judged, or wrong once and right when asked again alone).
data/hard_cases has cases that engines are known to get wrong, each with its truth and where it is from; its page
says how a library is tried on them without graze.

--add CASE.json makes a case of that folder of one that graze compare has written, and asks no engine: a line of the
file of --class, in plain numbers, with the truth for its answer, which the referee must prove, and with --origin, where
it is from. The counts in the folder's README.md are then those of its files. A case that is there is refused.

With --json one line: {"engines":[{"engine":"fcl","version":"0.7.0","all":{"passed":...,"failed":...,"refused":...,
"unknown":...},"classes":{"coplanar":{...},...}},...]}

Examples:
  graze scoreboard data/hard_cases
  graze scoreboard data/hard_cases --engines graze --engine-command ./mine
  graze scoreboard data/hard_cases/coplanar.jsonl --markdown table.md
  graze scoreboard data/hard_cases --add graze-cases/odd.json --class shapes --origin "found by graze compare"

Exit codes:
  0  graze passes, whatever others do
  1  graze fails a case
  2  bad input, with one line on stderr)";

}  // namespace

void add_scoreboard_command(CLI::App& program, Action& action) {
  auto options = std::make_shared<ScoreboardOptions>();
  auto added = std::make_shared<HardCaseOptions>();
  CLI::App* command =
      program.add_subcommand("scoreboard", "Who passes which hard cases: engines and classes");
  command->add_option("FILE", options->files, "cases, or folders of them; .jsonl: one on each line")
      ->required();
  command->add_option("--engines", options->engines, "names with commas (default: all)")
      ->type_name("NAMES");
  add_repeated_option(*command, "--engine-command", options->engine_commands,
                      "a program of your own that takes part", "COMMAND");
  command
      ->add_option("--timeout", options->timeout,
                   "so long another engine may take for a question (default: 60)")
      ->type_name("SECONDS")
      ->check(finite_number(Sign::Positive));
  command->add_option("--markdown", options->markdown, "the table for a page")
      ->type_name("FILE")
      ->check(file_name());
  command->add_flag("--json", options->is_json, "one JSON object on one line");
  command->add_flag("--progress", options->has_progress,
                    "report progress on stderr even if it is no terminal");
  CLI::Option* add =
      command->add_option("--add", added->file, "make a hard case of this one")->type_name("CASE");
  command->add_option("--class", added->kind, "of --add: the class that it joins")
      ->type_name("NAME")
      ->needs(add);
  command->add_option("--origin", added->origin, "of --add: where it is from (default: as it says)")
      ->type_name("TEXT")
      ->needs(add);
  command->add_option("--note", added->note, "of --add: what is hard (default: as it says)")
      ->type_name("TEXT")
      ->needs(add);
  command->footer(kScoreboardFooter);
  command->callback([options, added, &action] {
    action = [options, added](Output& output) {
      if (!added->file.empty()) {
        if (options->files.size() != 1) throw UsageError("--add is to one folder");
        added->folder = options->files.front();
        add_hard_case(*added, output);
        return ExitCode::Answered;
      }
      const compare::PeerSettings peers = {.timeout =
                                               std::chrono::duration<double>(options->timeout)};
      return run_scoreboard(*options, engines_with(peers, options->engine_commands), output);
    };
  });
}

}  // namespace graze::cli
