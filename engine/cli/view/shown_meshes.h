#pragma once

#include <graze/engine/cli/view/shown_pair.h>
#include <graze/engine/cli/view/view_run.h>

namespace graze::cli {

/// A page of one mesh, or of two, in a pose or one picture for each pose of a file. Throws
/// MeshError and PoseError for what cannot be read.
ShownPage show_meshes(const ViewOptions& options);

}  // namespace graze::cli
