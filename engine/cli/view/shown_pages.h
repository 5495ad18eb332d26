#pragma once

#include <string>

#include <graze/engine/cli/view/shown_pair.h>
#include <graze/engine/cli/view/view_run.h>

namespace graze::cli {

/// Makes a page of one mesh, or of two, in a pose or one picture for each pose of a file. Throws
/// MeshError and PoseError for what cannot be read.
ShownPage show_meshes(const ViewOptions& options);

/// Makes a page of cases, a picture each, or several where things move. Cases that cannot be read
/// are named on stderr and left out; throws CaseError where no other is left.
ShownPage show_cases(const ViewOptions& options);

/// True if a file is a scene, by its member "graze_scene". A file that cannot be read is none.
bool is_scene(const std::string& file);

/// Makes a page of a scene, a picture each step: its bodies as they move, and the contacts of those
/// that touch. Throws SceneError, and what a simulation throws.
ShownPage show_scene(const ViewOptions& options);

/// Makes a page of a recording, a picture each update: bodies as they came, moved and went, the
/// contacts of those that touch, and where pairs began and ended as the recording has it. Throws
/// RecordingError, and what repeating it throws.
ShownPage show_recording(const ViewOptions& options);

}  // namespace graze::cli
