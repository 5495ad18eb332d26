#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/output/output.h>
#include <graze/engine/cli/view/shown_tree.h>

namespace graze::cli {

/// Holds the arguments of `graze view` as they are given.
struct ViewOptions {
  std::vector<std::string> files =
      {};  ///< one or two meshes, cases and folders of them, a scene, or a recording
  std::string pose_a = {};
  std::string pose_b = {};
  std::optional<std::string> poses = {};  ///< empty is an error if it was given
  std::optional<TreeBoxes> tree = {};     ///< for meshes: the boxes of their trees are drawn, too
  std::string mesh_folder = {};  ///< the folder of meshes by file; empty for that of each case
  std::string page = "graze-view.html";  ///< the file of the page
  std::size_t every = 1;                 ///< one update of so many of a recording is shown
  std::string title = {};                ///< empty for the names of what is shown
  bool is_opened = false;                ///< true to open the page in the browser afterwards
  bool is_json = false;
  bool has_progress = false;
};

/// Writes the page and says where. Cases that cannot be read are named on stderr, one line each;
/// the others are shown, and the exit code is then BadInput. Throws UsageError for options that do
/// not go together, and what reading and writing throw.
ExitCode run_view(const ViewOptions& options, Output& output);

}  // namespace graze::cli
