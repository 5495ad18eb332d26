#include <graze/engine/cli/commands/commands.h>
#include <graze/engine/cli/compare/merge_run.h>
#include <graze/engine/cli/files/output_places.h>

#include <CLI/CLI.hpp>
#include <memory>

namespace graze::cli {
namespace {

constexpr const char* kMergeFooter = R"(
A comparison of two meshes is cut into N parts by graze compare ... --part K/N --resume FILE, for K from 1 to N, on
as many machines as there are. What they recorded is put together here: the answers, the verdicts and
the totals are those of one run. --save writes the record of all of them, with which the command of one
run goes on: it asks nothing again, and shrinks, reports, holds against what it is told to.

A part that was stopped goes on when its command is run again. Parts that are missing, there twice, incomplete,
damaged or of another job are refused by name. Of --fail-on, --junit and --markdown see graze compare --help.

Examples:
  graze merge *.part --save all.jsonl

Exit codes:
  0  graze is right everywhere
  1  exact arithmetic found an answer of graze to be wrong, or one that --fail-on names
  2  bad input, with one line on stderr)";

}  // namespace

void add_merge_command(CLI::App& program, Action& action) {
  auto options = std::make_shared<MergeOptions>();
  CLI::App* command = program.add_subcommand("merge", "The parts of a comparison, put together");
  command->add_option("PART", options->parts, "records of graze compare --part")->required();
  command->add_option("--save", options->save, "write the record of all of them")
      ->type_name("FILE")
      ->check(file_name());
  add_repeated_option(*command, "--fail-on", options->fail_on,
                      "exit code 1 also if this engine is wrong", "ENGINE[:CLASS][>SIZE]");
  command->add_option("--junit", options->junit, "what fails, as JUnit writes it")
      ->type_name("XML")
      ->check(file_name());
  command->add_option("--markdown", options->markdown, "a summary for code hosts")
      ->type_name("FILE")
      ->check(file_name());
  command->add_flag("--json", options->is_json, "the summary as one JSON object");
  command->add_flag("--progress", options->has_progress,
                    "report progress on stderr even if it is no terminal");
  command->footer(kMergeFooter);
  command->callback([options, &action] {
    action = [options](Output& output) { return run_merge(*options, output); };
  });
}

}  // namespace graze::cli
