#include <graze/engine/cli/commands/commands.h>
#include <graze/engine/cli/reports/explanation.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/pose_text.h>

#include <CLI/CLI.hpp>
#include <memory>

namespace graze::cli {
namespace {

constexpr const char* kExplainFooter = R"(
Why this answer: the stage that decided, the pair of triangles that decides, or came closest, and the stage
of a test of these two that is sure, a witness point or the separating axis; for a miss the largest boxes on
the way down to that pair that are apart, and along which axis, and of closed meshes whether one lies inside
the other; and what each kind of bounding volume let the query skip.

With --json the answer is one line:
  {"intersects":false,"pair":[a,b],"stage":"rounded","point_a":[x,y,z],"point_b":[...],"gap":...,
   "axis":[...],"decided_by":"volumes","boxes_apart":{"triangles":[n,m],"axis":"x of A",
   "direction":[...],"gap":...},"solids_intersect":false,"boxes":{"axis":"x of A","direction":[...],
   "gap":...},"pairs":...,"first_query":{...},"volumes":{"aabb":{"volume_tests":...,...},...}}
"stage" is "rounded", where a floating-point filter was sure, or "exact". For a miss alone: "axis";
"decided_by", the last stage that had to be asked: "boxes of the meshes", "volumes", "leaves" (bounds of the
gaps between triangles in leaves), "triangles" (tests in rounded arithmetic), "exact"; "boxes_apart", unless
the boxes of the leaves overlap; "solids_intersect", if both meshes are closed.

Examples:
  graze explain bolt.obj nut.stl --pose-b "1 0 0 0  0 1 0 0  0 0 1 0.002"

Exit codes:
  0  an answer was given, whatever it is
  2  bad input, with one line on stderr and nothing on stdout)";

struct ExplainOptions {
  std::string mesh_a;
  std::string mesh_b;
  std::string pose_a;
  std::string pose_b;
  bool is_json = false;
};

ExitCode run_explain(const ExplainOptions& options, Output& output) {
  const auto pose_of = [](const std::string& text, const char* option) {
    return text.empty() ? Pose(Pose::Identity()) : parse_pose(text, option);
  };
  const Pose pose_a = pose_of(options.pose_a, "--pose-a");
  const Pose pose_b = pose_of(options.pose_b, "--pose-b");
  const Mesh mesh_a = load_mesh(options.mesh_a);
  const Mesh mesh_b = options.mesh_b == options.mesh_a ? mesh_a : load_mesh(options.mesh_b);
  check_placement(pose_a, mesh_a.bounds(), "--pose-a");
  check_placement(pose_b, mesh_b.bounds(), "--pose-b");
  const Explanation explanation = explain({mesh_a, pose_a}, {mesh_b, pose_b});
  output.write(options.is_json ? to_json(explanation) : to_text(explanation));
  return ExitCode::Answered;
}

}  // namespace

void add_explain_command(CLI::App& program, Action& action) {
  auto options = std::make_shared<ExplainOptions>();
  CLI::App* command = program.add_subcommand("explain", "Why two meshes intersect, or do not");
  command->add_option("A", options->mesh_a, "first mesh: .obj, .stl, .ply or .off")->required();
  command->add_option("B", options->mesh_b, "second mesh")->required();
  command->add_option("--pose-a", options->pose_a, "pose of A (default: identity)")->type_name("P");
  command->add_option("--pose-b", options->pose_b, "pose of B (default: identity)")->type_name("P");
  command->add_flag("--json", options->is_json, "one JSON object on one line");
  command->footer(kExplainFooter);
  command->callback([options, &action] {
    action = [options](Output& output) { return run_explain(*options, output); };
  });
}

}  // namespace graze::cli
