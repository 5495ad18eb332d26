#pragma once

#include <string>

#include <graze/engine/cli/view/shown_pair.h>
#include <graze/engine/cli/view/view_run.h>

namespace graze::cli {

/// Whether a file is a scene, by its member "graze_scene". What cannot be read is none.
bool is_scene(const std::string& file);

/// A page of a scene, a picture each step: its bodies as they move, and the contacts of those that
/// touch. Throws SceneError, and what a simulation throws.
ShownPage show_scene(const ViewOptions& options);

}  // namespace graze::cli
