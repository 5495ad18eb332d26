#include <graze/engine/cli/commands/commands.h>
#include <graze/engine/cli/reports/contacts_report.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/pose_text.h>

#include <CLI/CLI.hpp>
#include <limits>
#include <memory>
#include <string>

namespace graze::cli {
namespace {

constexpr const char* kContactsFooter = R"(
A contact is a connected piece of what two surfaces have in common: a loop, several loops and patches
that meet, or a touching point. Its normal is a unit vector from A to B; its depth, along the normal,
is by how much the parts inside each other at this piece reach past each other, which is 0 for mere
touching. The deepest come first. Triangles are taken to turn counter-clockwise as seen from outside.
Lengths are in metres; a pose is 12 numbers as for graze pair.

With --json the answer is one line:
  {"contacts":[{"depth":...,"normal":[x,y,z],"point":[x,y,z],"point_a":[...],"point_b":[...],
   "corners":12},...],"complete":true,"work":{...}}
"point_a" is the point of A deepest in B, "point_b" that of B deepest in A, "point" midway between.
--list adds "list":[[x,y,z],...], the corners of the piece, and --separate adds
"separation":{"distance":...,"translation":[x,y,z]}, a translation of B after which the surfaces do not
meet. "complete" is false if --limit left some out.

Examples:
  graze contacts bolt.obj nut.stl --pose-b "1 0 0 0  0 1 0 0  0 0 1 0.002"
  graze contacts bolt.obj nut.stl --limit 4 --separate --json

Exit codes:
  0  an answer was given, whatever it is
  2  bad input, with one line on stderr and nothing on stdout)";

struct ContactsOptions {
  std::string mesh_a;
  std::string mesh_b;
  std::string pose_a;
  std::string pose_b;
  std::size_t limit = std::numeric_limits<std::size_t>::max();
  bool is_listing = false;
  bool is_separating = false;
  bool is_json = false;
};

Pose pose_named(const std::string& text, const char* option) {
  return text.empty() ? Pose::Identity() : parse_pose(text, option);
}

ExitCode run_contacts(const ContactsOptions& options, Output& output) {
  const Pose pose_a = pose_named(options.pose_a, "--pose-a");
  const Pose pose_b = pose_named(options.pose_b, "--pose-b");
  const Mesh mesh_a = load_mesh(options.mesh_a);
  // One file gives one mesh, so that its tree is shared, too.
  const Mesh mesh_b = options.mesh_b == options.mesh_a ? mesh_a : load_mesh(options.mesh_b);
  check_placement(pose_a, mesh_a.bounds(), "--pose-a");
  check_placement(pose_b, mesh_b.bounds(), "--pose-b");
  const PlacedMeshView a{mesh_a, pose_a};
  const PlacedMeshView b{mesh_b, pose_b};
  ContactsAnswer answer;
  answer.is_listing = options.is_listing;
  answer.contacts = find_contacts(a, b, {.limit = options.limit}, &answer.work);
  if (options.is_separating) answer.separation = separating_translation(a, b, &answer.work);
  output.write(options.is_json ? to_json(answer) : to_text(answer));
  return ExitCode::Answered;
}

}  // namespace

void add_contacts_command(CLI::App& program, Action& action) {
  auto options = std::make_shared<ContactsOptions>();
  CLI::App* command =
      program.add_subcommand("contacts", "Where two meshes meet: points, normals, depths");
  command->add_option("A", options->mesh_a, "first mesh: .obj, .stl, .ply or .off")->required();
  command->add_option("B", options->mesh_b, "second mesh")->required();
  command->add_option("--pose-a", options->pose_a, "pose of A (default: identity)")->type_name("P");
  command->add_option("--pose-b", options->pose_b, "pose of B (default: identity)")->type_name("P");
  command->add_option("--limit", options->limit, "at most so many contacts, the deepest")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber.description(""));
  command->add_flag("--list", options->is_listing, "print the corners of each contact");
  command->add_flag("--separate", options->is_separating,
                    "also a translation of B that separates them");
  command->add_flag("--json", options->is_json, "one JSON object on one line");
  command->footer(kContactsFooter);
  command->callback([options, &action] {
    action = [options](Output& output) { return run_contacts(*options, output); };
  });
}

}  // namespace graze::cli
