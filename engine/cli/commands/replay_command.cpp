#include <graze/engine/cli/commands/commands.h>
#include <graze/engine/cli/compare/engine_field.h>
#include <graze/engine/cli/files/output_places.h>
#include <graze/engine/cli/output/count_argument.h>
#include <graze/engine/cli/recordings/recording_file.h>
#include <graze/engine/cli/recordings/recording_run.h>
#include <graze/engine/cli/replay/replay_run.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>

namespace graze::cli {
namespace {

constexpr const char* kReplayFooter = R"(
A case is a query in a file, bit for bit (data/README.md, data/case.schema.json). Each is put to graze
and to every other engine that this command was built with, and the referee, exact arithmetic that shares
no formula with graze, says who is right. An answer is "right" only if every part of it was judged; else, if
nothing in it is wrong, it is "not judged", and the truth names what was not: normals and depths of contacts
of what is not convex, how an intersection is joined, questions of a mesh about itself. The answer that stands in
the file is judged too, and gets the class that it would get live. "changed" is an answer of graze other than the one that graze or the referee once gave: that is
right where a bug was fixed since. Most other engines have no query for rays, intersections and separations.
First contacts are judged by certificates of freedom and by contacts at a time; FCL has a query, with ten samples
and as "fcl-advancement", and Bullet one for convex shapes. What is wrong there is called missed, late, early,
or "hit" of a free motion.

Wrong answers have a class, the first that fits: degenerate (a triangle without area); by no more than
64 ulp: coplanar (one plane holds both triangles), pose rounding (right if placed otherwise), touching; beyond
that: not least (a way out, but a shorter one is there), containment (one mesh inside the other), real. Other
engines run in processes of their own: a crash, or no answer within --timeout, is an engine error, and what they
get wrong is asked again alone: if it is right then, it is "not confirmed".

With --json each case gives one line, with plain numbers that read back as the same doubles:
  {"case":FILE,"question":"any","testimonies":[{"engine":"graze","version":"0.1.0","recorded":false,
   "answer":{"says":true},"verdict":"right","truth":"hit","us":1.234},...],"silent":["ode"]}
and "silent" names the engines that know no such query, or refuse such shapes. Of answers that --fail-on
names it says "fails":true.

Only graze fails a replay by itself. --fail-on ENGINE adds the wrong answers of an engine, those that it gives
now and those that a case records of it; --fail-on recorded those that cases record, whoever gave them. With
:CLASS only errors of that class count: touching, pose-rounding, coplanar, degenerate, not-least, containment,
real, engine-error; with >SIZE behind only those larger than so many metres (quote the >).

--engine-command starts an engine of your own, as for graze compare.

A recording of a world (graze simulate --record) is repeated: this graze is given the same bodies, poses and
settings, update by update, and must say the same. The first update and pair that differ are named, and how many
updates do. --against holds another recording against it, such as that of another version or machine. With --json:
  {"file":FILE,"engine":"0.2.0","against":null,"updates":N,"complete":true,"differing":0}
and where something differs
  "difference":{"update":I,"what":"begun","time":S,"pair":["a","b"],"is_input":false,"first":T,"second":T}
"complete":false means that its writer was stopped: what there is was repeated.

Examples:
  graze replay odd.json
  graze replay data/regressions --json
  graze replay graze-cases --fail-on recorded:real --fail-on fcl
  graze replay run.recording --threads 8 --work
  graze replay old.recording --against new.recording --json

Exit codes:
  0  graze is right everywhere, or was not judged
  1  exact arithmetic found an answer of graze to be wrong, or one that nobody judges has changed; of a
     recording, something differs; with
     --same also if any has changed; with --fail-on also if an answer that it names is wrong
  2  bad input, with one line on stderr for each bad file, FILE:LINE: /PLACE: why; the others are replayed)";

/// Holds the options that are about recordings.
struct RecordedRunOptions {
  std::optional<std::string> against;
  std::optional<int> threads;
  bool has_work = false;
};

/// Returns the run of a recording, if one is meant; all options must be about one.
std::optional<RecordingOptions> recording_of(const ReplayOptions& options,
                                             const RecordedRunOptions& run) {
  const bool has_any = std::any_of(options.files.begin(), options.files.end(), is_recording);
  if (!has_any) {
    if (run.against || run.threads || run.has_work)
      throw UsageError("--against, --threads and --work are about a recording: here is none");
    return std::nullopt;
  }
  if (options.files.size() != 1) throw UsageError("a recording is replayed by itself");
  if (!options.fail_on.empty() || options.is_change_failure || !options.engine_commands.empty() ||
      !options.mesh_folder.empty())
    throw UsageError(
        "--meshes, --same, --fail-on and --engine-command are about cases: here is a recording");
  if (run.against && run.threads)
    throw UsageError("--threads is about repeating a recording, not about --against");
  return RecordingOptions{.file = options.files.front(),
                          .against = run.against,
                          .threads = run.threads.value_or(1),
                          .has_work = run.has_work,
                          .is_json = options.is_json,
                          .has_progress = options.has_progress};
}

}  // namespace

void add_replay_command(CLI::App& program, Action& action) {
  auto options = std::make_shared<ReplayOptions>();
  auto run = std::make_shared<RecordedRunOptions>();
  CLI::App* command = program.add_subcommand(
      "replay", "Ask every engine the questions of case files, or repeat a recording");
  command
      ->add_option("FILE", options->files,
                   "cases, or folders of them; .jsonl: one on each line; or a recording")
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
  command->add_option("--against", run->against, "another recording, to be held against the first")
      ->type_name("FILE")
      ->check(file_name());
  command->add_option("--threads", run->threads, "of a repeated recording's world (default: 1)")
      ->type_name("N")
      ->check(whole_number(0, kMaxThreads));
  command->add_flag("--work", run->has_work, "of a recording, compare work counters, too");
  command->add_flag("--progress", options->has_progress,
                    "report progress on stderr even if it is no terminal");
  command->footer(kReplayFooter);
  command->callback([options, run, &action] {
    action = [options, run](Output& output) {
      if (const auto recording = recording_of(*options, *run))
        return run_recording(*recording, output);
      const compare::PeerSettings peers = {.timeout =
                                               std::chrono::duration<double>(options->timeout)};
      return run_replay(*options, engines_with(peers, options->engine_commands), output);
    };
  });
}

}  // namespace graze::cli
