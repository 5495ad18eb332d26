#include <graze/engine/cli/commands/commands.h>
#include <graze/engine/cli/compare/compare_run.h>
#include <graze/engine/cli/compare/engine_field.h>
#include <graze/engine/cli/compare/shell_word.h>
#include <graze/engine/cli/files/output_places.h>
#include <graze/engine/cli/output/count_argument.h>
#include <graze/engine/scenes/read_scene.h>

#include <CLI/CLI.hpp>
#include <limits>
#include <memory>

namespace graze::cli {
namespace {

constexpr const char* kCompareFooter = R"(
Each pose of B is put to graze and to every other engine that this command was built with. Where they
differ, a referee in exact arithmetic that shares no formula with graze says who is right; distances, times and contacts are
always settled. Wrong answers have a class (see graze replay --help), are shrunk, mostly to two
triangles, and written as cases to --cases. What an engine
returns that is no answer (triangles that are not there, no number, a throw) is an engine error. Other engines
run in processes of their own (graze-peer), so that a crash of theirs is an engine error, too, and so is an answer
that does not come within --timeout. What one of them gets wrong is asked again where nothing else was asked;
if it is right then, it is "not confirmed", and counted, but not held against it.

Of --query first_contact and free B moves from each of the --poses to the next, straight and turning the
short way. FCL is asked twice, with its ten samples and as "fcl-advancement", Bullet about convex shapes and a mesh beside
one; their other settings take part if --engines names them (fcl-1000, fcl-swapped, fcl-screw, fcl-polynomial, bullet-gjk
and so on). Answers are judged by certificates of freedom and by contacts at a time (see graze replay --help).

Shrinking starts from the guilty pair of triangles and, if the engine is right about these alone, from
what is near it. It takes --shrink-seconds in all, and as much more as the question that is being asked
then; each case is written before what takes long, and again as it gets smaller. The file of a case is named after
what is compared, the engine, the question, the pose or the step, the class of the error, and a digest of the whole
question: other questions have other names, and a run that is repeated writes the same ones. Cases of other runs stay
in the folder, and the run says how many there are. A folder that cannot be written stops nothing: stderr says so
once, and "written" is false.

--engine-command starts an engine of your own: a program that says who it is and answers lines of JSON on its
standard output (engine/compare/peers/process/README.md; samples/engines has clients of a page). The line is
run by /bin/sh once for each thread that asks, and again after a crash or a --timeout, which are engine errors. It
takes part whatever --engines says: with --engines graze alone beside graze.

Of a folder of cases, or a file .jsonl with one on each line, each is put to all engines as it says itself, and every answer is judged, also the
one that stands in the case ("recorded"). Wrong of graze is also what differs from an answer that graze or
the referee once gave. A case that cannot be made smaller stays where it is.

Of a scene (see graze simulate) each pair of bodies at each step is put to graze::World, to graze alone
and to the engines that know such shapes. Two meshes, and boxes and balls with them, are the referee's;
for other shapes a plane between them or a point in both is proof, and errors within 1e-6 of their size are
called touching. What is not proved is not judged. FCL's managers (fcl-tree, fcl-sap, fcl-hash and so on) take part as
engines of scenes: each gets all bodies of a step and looks for the pairs itself. Cases of such shapes hold the two bodies, their meshes
and hulls cut down to what the error needs. With --query first_contact or free each pair is asked about its ways
from each step to the next: whom the World lists, all that moves being swept, against the pair alone and both ways
of FCL's. Judged, by certificates and contacts at a time, is what somebody does not call free, and all of two meshes.

With --json each pose, or case, gives one line, and the last one is
  {"summary":[{"engine":"fcl","answers":...,"wrong":...,...},...],
   "cases":[{"file":...,"written":true,"engine":"fcl","pose":3,"class":"real","least":false,"stopped":false},...]}

where "stopped" says that the time for shrinking was over, and "least" that no triangle of many can go;

of a folder each line has what the case is called:
  {"case":3,"file":"odd.json","question":"any","answers":[{"engine":"recorded",...},...]}

and of a scene each difference:
  {"step":3,"time":0.06,"a":"gear","b":"pinion","answers":[{"engine":"world","says":true,...},...]}
where a first contact is said in words, "hit at 0.333".

--save writes what was answered, and --against holds a run against such a file: every answer of graze
must be the same bit for bit, and the median of its times, each beside what it was, within --time-tolerance.
Files appear whole or not at all; pipes and devices are written through. --resume FILE keeps a
record of each pose, step or case as it is done, and goes on where a stopped run ended. Interrupted by ^C, a run
with --resume finishes what it has begun and says how far it came; a second ^C ends it at once. Times of runs with many
threads are those of a busy machine: use --threads 1 for --save and --against.

Of a run nothing is held but what it is about to judge: memory does not grow with the poses, and those of
a file stay there. A record (engine/compare/README.md) has some 7 bytes a pose on which two engines agree. A run
that was killed goes on like one that was interrupted. --part K/N asks the K-th of N parts alone, each with a
record of its own; graze merge puts them together.

In place of a mesh A and B may be shapes, .json files that hold what a body of a case has ({"sphere":{"radius":1}}).
Every question but pairs is asked about them, of every engine that knows it: FCL, Coal and Bullet know distances, within
and contacts, ODE contacts; of all four the depth of the deepest contact along its normal is their separation, a
translation of B that parts the two. Of meshes only graze knows separations. Of what is curved a plane that parts the two and two points of them bound a distance, and
what is wrong names both bounds.

Below the table stands what to do about each class of errors: a tolerance, poses, single precision on the way,
triangles without area, another question, or a bug to report, for which --report, --markdown and --json have the text of
an issue. With --json it is a line before the last one,
  {"advice":[{"engine":"fcl","class":"real","count":3,"looked_at":3,"steps":[{"remedy":"report","words":...}],"issue":...}]}

--answers reads what an engine said elsewhere (samples/engines/README.md): one line a pose behind one that names the
meshes by their SHA-256, the question and the engine. It is judged as any other. If its name is taken it gets its
version behind it, fcl@0.7.0: so two versions of one engine stand beside each other.

--against tells of every engine what has changed and who was right before and now. Only changes of graze fail
the run, and those that --fail-on ENGINE:changed names. --answer-tolerance lets distances differ by so many metres.

Only graze fails a comparison by itself. --fail-on ENGINE adds the wrong answers of an engine, :CLASS only those
of a class (touching, pose-rounding, coplanar, degenerate, not-least, containment, real, engine-error), >SIZE only
errors larger than so many metres; quote the >. The last line counts them: {"fail_on":2} with --json. --junit and --markdown
write what fails, and the table of engines, for what shows them in a code host (samples/compare_in_ci.md).

Examples:
  graze compare bolt.obj nut.stl --poses poses.txt --query pairs
  graze compare gear.ply pinion.off --grazing 1000 --seed 7 --report out.html
  graze compare bolt.obj nut.stl --random 100000 --resume run.jsonl
  graze compare bolt.obj nut.stl --random 100000 --part 3/8 --resume part3.jsonl
  graze compare bolt.obj nut.stl --poses poses.npy --answers mine.jsonl --fail-on mine
  graze compare bolt.obj nut.stl --poses poses.txt --query first_contact
  graze compare capsule.json box.json --grazing 1000 --query distance
  graze compare bolt.obj nut.stl --random 1000 --engines graze --engine-command ./mine --fail-on mine
  graze compare bolt.obj nut.stl --grazing 1000 --fail-on 'fcl:real>1e-9' --junit fcl.xml
  graze compare data/regressions --save base
  graze compare data/regressions --against base --report out.html
  graze compare data/scenes/machine.json --meshes data/meshes --engines fcl
  graze compare data/scenes/fast.json --query first_contact

Exit codes:
  0  graze is right everywhere
  1  exact arithmetic found an answer of graze to be wrong, or one that --fail-on names, or --against found
     a regression
  2  bad input, with one line on stderr, or a folder of --cases that could not be written
  130  interrupted, with --resume: what is done is recorded)";

/// More poses would take years.
constexpr std::uint64_t kMostPoses = 1'000'000'000'000;

void add_pose_options(CLI::App& command, CompareOptions& options) {
  command.add_option("--pose-a", options.pose_a, "pose of A (default: identity)")->type_name("P");
  command.add_option("--pose-b", options.pose_b, "pose of B (default: identity)")->type_name("P");
  command.add_option("--poses", options.poses, "poses of B, one per line, or .npy")
      ->type_name("FILE");
  command.add_option("--random", options.random, "so many random poses of B")
      ->type_name("N")
      ->check(whole_number(1, kMostPoses));
  command
      .add_option("--grazing", options.grazing,
                  "so many poses halved to the touching point, where engines go wrong")
      ->type_name("N")
      ->check(whole_number(1, kMostPoses));
  command.add_option("--seed", options.seed, "of --random and --grazing (default: 1)")
      ->type_name("S")
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()));
}

void add_scene_options(CLI::App& command, CompareOptions& options) {
  command.add_option("--steps", options.steps, "of a scene (default: as it says)")
      ->type_name("N")
      ->check(whole_number(0, kMaxSceneSteps));
  command.add_option("--dt", options.step, "of a scene, seconds a step (default: as it says)")
      ->type_name("S")
      ->check(finite_number(Sign::Positive));
  command
      .add_option("--meshes", options.mesh_folder,
                  "the folder of meshes of a scene or of cases (default: its own)")
      ->type_name("DIR");
}

void add_output_options(CLI::App& command, CompareOptions& options) {
  command
      .add_option("--cases", options.cases, "the folder for shrunk cases (default: graze-cases)")
      ->type_name("DIR")
      ->check(file_name());
  command.add_option("--keep", options.keep, "at most so many of them, the worst (default: 16)")
      ->type_name("N")
      ->check(whole_number(0, 1'000'000));
  command
      .add_option("--shrink-seconds", options.shrink_seconds,
                  "for shrinking all of them (default: 10; 0: as they were found)")
      ->type_name("S")
      ->check(finite_number(Sign::NotNegative));
  command.add_option("--report", options.report, "also one self-contained page")
      ->type_name("HTML")
      ->check(file_name());
  add_repeated_option(command, "--fail-on", options.fail_on,
                      "exit code 1 also if this engine is wrong", "ENGINE[:CLASS][>SIZE]");
  command.add_option("--junit", options.junit, "what fails, as JUnit writes it")
      ->type_name("XML")
      ->check(file_name());
  command.add_option("--markdown", options.markdown, "a summary for code hosts")
      ->type_name("FILE")
      ->check(file_name());
  command.add_option("--save", options.save, "write what was answered")
      ->type_name("BASE")
      ->check(file_name());
  command.add_option("--against", options.against, "hold this run against a saved one")
      ->type_name("BASE")
      ->check(file_name());
  command
      .add_option("--time-tolerance", options.time_tolerance,
                  "how much longer graze may take than in --against (default: 1.5)")
      ->type_name("RATIO");
  command.add_option("--resume", options.resume, "keep a record, and go on where it ends")
      ->type_name("FILE")
      ->check(file_name());
  command.add_option("--part", options.part, "of so many parts this one, which keep a record each")
      ->type_name("K/N");
  command
      .add_option("--answer-tolerance", options.answer_tolerance,
                  "of --against: so far off a distance is the same (default: 0, bit for bit)")
      ->type_name("METRES")
      ->check(finite_number(Sign::NotNegative));
  command.add_option("--threads", options.threads, "0 (default): as many as processors")
      ->type_name("N")
      ->check(whole_number(0, kMaxThreads));
  command
      .add_option("--timeout", options.timeout,
                  "so long another engine may take for a question (default: 60)")
      ->type_name("SECONDS")
      ->check(finite_number(Sign::Positive));
  command.add_flag("--json", options.is_json, "one JSON object per line");
  command.add_flag("--progress", options.has_progress,
                   "report progress on stderr even if it is no terminal");
}

}  // namespace

void add_compare_command(CLI::App& program, Action& action,
                         const std::vector<std::string>& arguments) {
  auto options = std::make_shared<CompareOptions>();
  options->command = shell_line(arguments);
  CLI::App* command =
      program.add_subcommand("compare", "Who is right: graze and other engines before a referee");
  command
      ->add_option("A", options->mesh_a, "first mesh, or a scene, or a folder or a .jsonl of cases")
      ->required();
  command->add_option("B", options->mesh_b, "second mesh");
  command
      ->add_option(
          "--query", options->query,
          "any (default), pairs, distance, within, contacts, separation, first_contact, free")
      ->type_name("QUESTION")
      ->check(CLI::IsMember({"any", "pairs", "distance", "within", "contacts", "separation",
                             "first_contact", "free"})
                  .description(""));
  command
      ->add_option("--clearance", options->clearance,
                   "of --query within, first_contact and free, metres")
      ->type_name("C")
      ->check(finite_number(Sign::NotNegative));
  command->add_option("--engines", options->engines, "names with commas (default: all)")
      ->type_name("NAMES");
  add_repeated_option(*command, "--engine-command", options->engine_commands,
                      "a program of your own that takes part", "COMMAND");
  add_repeated_option(*command, "--answers", options->answers,
                      "answers that an engine gave elsewhere, which are judged, too", "FILE");
  add_pose_options(*command, *options);
  add_scene_options(*command, *options);
  add_output_options(*command, *options);
  command->footer(kCompareFooter);
  command->callback([options, &action] {
    action = [options](Output& output) {
      const compare::PeerSettings peers = peer_settings(*options);
      return run_compare(*options, engines_with(peers, options->engine_commands), output);
    };
  });
}

}  // namespace graze::cli
