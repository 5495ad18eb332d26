#include <graze/engine/cli/commands/commands.h>
#include <graze/engine/cli/files/output_places.h>
#include <graze/engine/cli/output/count_argument.h>
#include <graze/engine/cli/view/view_run.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <string>

namespace graze::cli {
namespace {

constexpr const char* kViewFooter = R"(
The page is one file that any browser opens, without a network: turn by mouse, fingers or arrow
keys, play, jump to where touching begins or ends, cut, measure, save a picture. Two meshes are
shown in the pose, or a picture for each pose of --poses: intersecting triangles red, curves of
intersection, contacts with normals and depths; or else the nearest points, the gap, and a plane
that separates them, if the one across the gap does. With --tree the boxes of the trees that
queries walk are there, too, a level at a time. Of cases each is a picture, and 49 where things
move; of a scene each step; of a recording (graze simulate --record) each update, or one of --every
and all in which something begins or ends. What is shown is asked of graze anew, by exact queries;
coordinates are drawn as floats. A case that cannot be read is named, and the page says so. With
-o FILE.glb a recording becomes animated glTF 2.0, for other programs.

With --json the answer is one line:
  {"file":"page.html","pictures":36,"touching":12,"bytes":1000036}

Examples:
  graze view bolt.obj nut.stl --pose-b "1 0 0 0  0 1 0 0  0 0 1 0.002" -o page.html
  graze view bolt.obj nut.stl --poses poses.txt --open
  graze view bolt.obj nut.stl --tree obb -o tree.html
  graze view odd.json --json
  graze view data/regressions -o cases.html
  graze view data/scenes/machine.json --meshes data/meshes -o scene.html
  graze view run.recording --every 4 -o run.html
  graze view run.recording -o run.glb

Exit codes:
  0  the page was written
  2  bad input, or a file that cannot be written, with one line on stderr; of several cases the
     others are shown)";

const std::map<std::string, TreeBoxes> kTreeBoxes = {{"aabb", TreeBoxes::Aabb},
                                                     {"obb", TreeBoxes::Obb}};

}  // namespace

void add_view_command(CLI::App& program, Action& action) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command = program.add_subcommand(
      "view", "A page that shows a pose, a motion, cases, a scene or a recording, to be turned");
  command
      ->add_option("FILE", options->files,
                   "one or two meshes; cases or folders of them; a scene; a recording")
      ->required();
  command->add_option("--pose-a", options->pose_a, "pose of A (default: identity)")->type_name("P");
  command->add_option("--pose-b", options->pose_b, "pose of B (default: identity)")->type_name("P");
  command
      ->add_option("--poses", options->poses, "poses of B, one per line, or .npy, each a picture")
      ->type_name("FILE");
  command
      ->add_option("--tree", options->tree, "of meshes: the boxes of their trees, level by level")
      ->transform(CLI::Transformer(kTreeBoxes).description(""))
      ->transform(CLI::IsMember({"aabb", "obb"}).description(""))  // this comes first
      ->type_name("aabb|obb");
  command
      ->add_option("--meshes", options->mesh_folder,
                   "the folder of meshes by file (default: that of each case)")
      ->type_name("DIR");
  command
      ->add_option("-o,--output", options->page, "where the page goes (default: graze-view.html)")
      ->type_name("FILE")
      ->check(file_name());
  command
      ->add_option("--every", options->every, "of a recording one update of so many (default: 1)")
      ->type_name("N")
      ->check(whole_number(1, 1'000'000));
  command->add_option("--title", options->title, "the heading (default: the names of the files)")
      ->type_name("TEXT");
  command->add_flag("--open", options->is_opened, "open the page in a browser");
  command->add_flag("--json", options->is_json, "say as JSON what was written");
  command->add_flag("--progress", options->has_progress,
                    "report progress on stderr even if it is no terminal");
  command->footer(kViewFooter);
  command->callback([options, &action] {
    action = [options](Output& output) { return run_view(*options, output); };
  });
}

}  // namespace graze::cli
