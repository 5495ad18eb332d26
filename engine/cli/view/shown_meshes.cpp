#include <graze/engine/cli/view/shown_pages.h>

#include <graze/engine/cli/output/progress.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/pose_text.h>

#include <filesystem>
#include <string>
#include <vector>

namespace graze::cli {
namespace {

std::string file_name_of(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

Pose pose_of(const std::string& text, const char* option) {
  return text.empty() ? Pose::Identity() : parse_pose(text, option);
}

/// Returns the poses of B, with line 0 for one that comes from the command line.
std::vector<PoseLine> poses_of(const ViewOptions& options) {
  if (options.poses) return load_pose_lines(*options.poses);
  return {{pose_of(options.pose_b, "--pose-b"), 0}};
}

/// Refuses a pose before the first question is asked.
void check_poses(const ViewOptions& options, const std::vector<PoseLine>& poses, const Mesh& mesh) {
  for (const PoseLine& pose : poses) {
    const std::string place =
        pose.line == 0 ? "--pose-b" : *options.poses + ":" + std::to_string(pose.line);
    check_placement(pose.pose, mesh.bounds(), place.c_str());
  }
}

/// Adds a body, with the boxes of its tree if these are asked for.
ViewBody add(const Mesh& mesh, const std::string& name, const ViewOptions& options, View& view) {
  const ViewBody body = view.add(mesh, {.name = name});
  if (!options.tree) return body;
  if (const auto level = add_tree(mesh, *options.tree, body, view))
    view.add_note(name + ": boxes of its tree from level " + std::to_string(*level) +
                  " on are left out, for there are too many to be seen.");
  return body;
}

}  // namespace

ShownPage show_meshes(const ViewOptions& options) {
  const Pose pose_a = pose_of(options.pose_a, "--pose-a");
  const std::string name_a = file_name_of(options.files[0]);
  if (options.files.size() == 1) {
    const Mesh mesh = load_mesh(options.files[0]);
    check_placement(pose_a, mesh.bounds(), "--pose-a");
    ShownPage page({.title = options.title.empty() ? name_a : options.title});
    page.view.place(add(mesh, name_a, options, page.view), pose_a);
    page.frames = 1;
    return page;
  }
  const std::vector<PoseLine> poses = poses_of(options);
  const std::string name_b = file_name_of(options.files[1]);
  const Mesh mesh_a = load_mesh(options.files[0]);
  const Mesh mesh_b = options.files[1] == options.files[0] ? mesh_a : load_mesh(options.files[1]);
  check_placement(pose_a, mesh_a.bounds(), "--pose-a");
  check_poses(options, poses, mesh_b);
  ViewSettings settings = {.title = options.title.empty() ? name_a + ", " + name_b : options.title};
  if (poses.size() > 1)
    settings.notes.emplace_back(
        "Each picture is a pose of the file. What is between two of them "
        "was not asked: graze motion does.");
  ShownPage page(settings);
  const ShownBodies bodies = {add(mesh_a, name_a, options, page.view),
                              add(mesh_b, name_b, options, page.view)};
  Progress progress("poses:", poses.size(), {.is_forced = options.has_progress, .has_rows = false});
  for (std::size_t i = 0; i < poses.size(); ++i) {
    PictureWords words;
    if (options.poses) words.label = "line " + std::to_string(poses[i].line);
    show_pair(PlacedMeshView(mesh_a, pose_a), PlacedMeshView(mesh_b, poses[i].pose), bodies, words,
              page);
    progress.update(i + 1);
  }
  return page;
}

}  // namespace graze::cli
