#include <graze/engine/cli/commands/commands.h>
#include <graze/engine/cli/compare/engine_field.h>
#include <graze/engine/cli/output/count_argument.h>
#include <graze/engine/cli/replay/replay_run.h>

#include <CLI/CLI.hpp>
#include <memory>

namespace graze::cli {
namespace {

constexpr const char* kReplayFooter = R"(
A case is a query in a file, bit for bit (data/README.md, data/case.schema.json). Each is put to graze
and to every other engine that this command was built with, and the referee, exact arithmetic that shares
no formula with graze, says who is right. An answer is "right" only if every part of it was judged; else, if
nothing in it is wrong, it is "not judged", and the truth names what was not: normals and depths of contacts
of what is not convex, how an intersection is joined, questions of a mesh about itself. The answer that stands in
the file is judged too, by itself. "changed" is an answer of graze other than the one that graze or the referee once gave: that is
right where a bug was fixed since. Most other engines have no query for rays, intersections and separations.
First contacts are judged by certificates of freedom and by contacts at a time; of these only FCL has a query, with
ten samples, and as "fcl-advancement". What is wrong there is called missed, late, early, or "hit" of a free motion.

Wrong answers have a class, the first that fits: degenerate (a triangle without area); by no more than
64 ulp: coplanar (one plane holds both triangles), pose rounding (right without poses), touching; beyond
that: containment (one mesh inside the other), real. Other engines run in processes of their own: a crash, or
no answer within --timeout, is an engine error, and what they get wrong is asked again alone: if it is right
then, it is "not confirmed".

With --json each case gives one line, with plain numbers that read back as the same doubles:
  {"case":FILE,"question":"any","testimonies":[{"engine":"graze","version":"0.1.0","recorded":false,
   "answer":{"says":true},"verdict":"right","truth":"hit","us":1.234},...],"silent":["ode"]}
and "silent" names the engines that know no such query, or refuse such shapes. Of answers that --fail-on
names it says "fails":true.

Only graze fails a replay by itself. --fail-on ENGINE adds the wrong answers of an engine, those that it gives
now and those that a case records of it; --fail-on recorded those that cases record, whoever gave them. With
:CLASS only errors of that class count: touching, pose-rounding, coplanar, degenerate, containment, real,
engine-error; with >SIZE behind only those larger than so many metres (quote the >).

--engine-command starts an engine of your own, as for graze compare.

Examples:
  graze replay odd.json
  graze replay data/regressions --json
  graze replay graze-cases --fail-on recorded:real --fail-on fcl

Exit codes:
  0  graze is right everywhere, or was not judged
  1  exact arithmetic found an answer of graze to be wrong, or one that nobody judges has changed; with
     --same also if any has changed; with --fail-on also if an answer that it names is wrong
  2  bad input, with one line on stderr for each bad file, FILE:LINE: /PLACE: why; the others are replayed)";

}  // namespace

void add_replay_command(CLI::App& program, Action& action) {
  auto options = std::make_shared<ReplayOptions>();
  CLI::App* command =
      program.add_subcommand("replay", "Ask every engine the questions of case files");
  command->add_option("FILE", options->files, "cases, or folders of them; .jsonl: one on each line")
      ->required();
  command
      ->add_option("--meshes", options->mesh_folder,
                   "the folder of meshes by file (default: that of each case)")
      ->type_name("DIR");
  command
      ->add_option("--timeout", options->timeout,
                   "so long another engine may take for a question (default: 60)")
      ->type_name("SECONDS")
      ->check(finite_number(Sign::Positive));
  add_repeated_option(*command, "--engine-command", options->engine_commands,
                      "a program of your own that takes part", "COMMAND");
  command->add_flag("--json", options->is_json, "one JSON object per line and case");
  command->add_flag("--same", options->is_change_failure,
                    "fail if an answer of graze is not the one that the case records");
  add_repeated_option(*command, "--fail-on", options->fail_on,
                      "exit code 1 also if this engine is wrong, now or in a record",
                      "ENGINE[:CLASS][>SIZE]");
  command->add_flag("--progress", options->has_progress,
                    "report progress on stderr even if it is no terminal");
  command->footer(kReplayFooter);
  command->callback([options, &action] {
    action = [options](Output& output) {
      const compare::PeerSettings peers = {.timeout =
                                               std::chrono::duration<double>(options->timeout)};
      return run_replay(*options, engines_with(peers, options->engine_commands), output);
    };
  });
}

}  // namespace graze::cli
