#include <graze/engine/cli/commands/commands.h>
#include <graze/engine/cli/files/output_places.h>
#include <graze/engine/cli/output/count_argument.h>
#include <graze/engine/cli/output/interruption.h>
#include <graze/engine/cli/output/progress.h>
#include <graze/engine/cli/recordings/scene_recorder.h>
#include <graze/engine/cli/reports/simulate_report.h>
#include <graze/engine/scenes/read_scene.h>
#include <graze/engine/scenes/simulation.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <optional>
#include <string>

namespace graze::cli {
namespace {

constexpr const char* kSimulateFooter = R"(
A scene is a JSON file (data/README.md, data/scene.schema.json): shapes, bodies in poses, filters, and how
bodies move, by poses at times or at a constant velocity and rate. Step 0 is time 0, step n is n times
the step later. Each step gives a row: how many pairs of bodies began and ceased to touch and touch
now, what the world did for that, and of how many meshes nobody has needed a tree. The pairs follow
by name.

--contacts adds where the pairs touch in which something moved: depth and point in metres, and the
normal, a unit vector from the first body to the second.

Bodies of the scene that are swept ("detection": "continuous") are told whom they met on their way since the
step before, and when, in seconds; or that they touched already. "came close" is nearer than 1e-6 m, and no
contact proved.

--record FILE writes the run down, each step as it is done: "graze replay FILE" repeats it, on any version
and with any number of threads, and "graze view FILE" plays it (engine/record/README.md). It keeps the contacts of
pairs that begin to touch, with --contacts of all. A run that is stopped by SIGINT, or killed, leaves a file that can
be read up to its last step.

With --json each step gives one line:
  {"step":0,"time":0,"begun":[["a","b"],...],"ended":[],"touching":1,
   "contacts":[{"a":"a","b":"b","points":[{"depth":...,"normal":[x,y,z],"point":[x,y,z]},...]},...],
   "work":{...}}
"contacts" is there only with --contacts. Where bodies are swept there is also
  "first_contacts":[{"a":"a","b":"b","status":"hit"|"close","time":S,"low":0..1,"high":0..1,
   "is_out_of_budget":false,"is_at_start":false,"normal":[x,y,z],"point":[x,y,z]},...]
with "low" and "high" as shares of the step. Of a body of several shapes ("parts" in the scene) each part that
meets has an entry of its own, with its place in the list of parts as "part_a" or "part_b".

Examples:
  graze simulate data/scenes/shapes.json
  graze simulate data/scenes/fast.json --json
  graze simulate data/scenes/parts.json --contacts
  graze simulate data/scenes/terrain.json
  graze simulate data/scenes/machine.json --meshes data/meshes --steps 20 --contacts --json
  graze simulate data/scenes/shapes.json --record shapes.recording

Exit codes:
  0  an answer was given, whatever it is
  2  bad input, with one line on stderr and nothing on stdout: FILE:LINE: /PLACE: why
  130  with --record: stopped by SIGINT; the steps until then are in the file)";

struct SimulateOptions {
  std::string scene;
  std::string mesh_folder;
  std::optional<std::string> record;
  std::optional<std::size_t> steps;
  double step = 0;
  int threads = 1;
  bool has_contacts = false;
  bool is_json = false;
  bool has_progress = false;
};

/// Ends a recorded run after a step if SIGINT asks for it, so that the file has its end.
void stop_if_asked(const SimulateOptions& options, SceneRecorder& recorder, std::size_t steps) {
  recorder.check();
  if (!options.record || !Interruption::is_requested()) return;
  recorder.finish();
  throw Interrupted("interrupted: " + *options.record + " has the steps until " +
                    std::to_string(steps));
}

ExitCode run_simulate(const SimulateOptions& options, Output& output) {
  const Scene scene = read_scene(options.scene, {.mesh_folder = options.mesh_folder});
  const std::size_t steps = options.steps.value_or(scene.steps);
  const std::array<FilePlace, 1> inputs = {{{"the scene", options.scene}}};
  const std::array<FilePlace, 1> outputs = {{{"--record", options.record.value_or("")}}};
  check_outputs(outputs, inputs);
  Simulation simulation(scene, {.step = options.step,
                                .world = {.threads = options.threads,
                                          .contacts = options.has_contacts || options.record}});
  check_paths(scene, simulation.time_of(steps));  // so that bad input leaves standard output empty
  SimulateReport report(output, scene,
                        {.is_json = options.is_json, .has_contacts = options.has_contacts});
  std::optional<Interruption> interruption;
  if (options.record) interruption.emplace();
  SceneRecorder recorder(options.record, scene, simulation,
                         options.has_contacts ? RecordedContacts::All : RecordedContacts::Begun);
  report.begin();
  Progress progress("steps:", steps, {.is_forced = options.has_progress});
  for (std::size_t i = 0; i <= steps; ++i) {
    const WorldUpdate update = simulation.advance();
    report.add(simulation.steps(), simulation.time(), update);
    progress.update(i);
    if (i < steps) stop_if_asked(options, recorder, i);
  }
  recorder.finish();
  return ExitCode::Answered;
}

}  // namespace

void add_simulate_command(CLI::App& program, Action& action) {
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = program.add_subcommand(
      "simulate", "Step the bodies of a scene: which begin and cease to touch");
  command->add_option("SCENE", options->scene, "a JSON file")->required();
  command
      ->add_option("--steps", options->steps, "how many after step 0 (default: as the scene says)")
      ->type_name("N")
      ->check(whole_number(0, kMaxSceneSteps));
  command->add_option("--dt", options->step, "seconds a step (default: as the scene says)")
      ->type_name("S")
      ->check(finite_number(Sign::Positive));
  command
      ->add_option("--meshes", options->mesh_folder,
                   "the folder of meshes by file (default: that of the scene)")
      ->type_name("DIR");
  command->add_option("--threads", options->threads, "no answer depends on it (default: 1)")
      ->type_name("N")
      ->check(whole_number(0, kMaxThreads));
  command->add_flag("--contacts", options->has_contacts, "also where bodies touch");
  command
      ->add_option("--record", options->record, "write the run down, to be repeated and looked at")
      ->type_name("FILE")
      ->check(file_name());
  command->add_flag("--json", options->is_json, "one JSON object per line and step");
  command->add_flag("--progress", options->has_progress,
                    "report progress on stderr even if it is no terminal");
  command->footer(kSimulateFooter);
  command->callback([options, &action] {
    action = [options](Output& output) { return run_simulate(*options, output); };
  });
}

}  // namespace graze::cli
