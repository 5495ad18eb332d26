#pragma once

#include <graze/engine/cli/view/shown_pair.h>
#include <graze/engine/cli/view/view_run.h>

namespace graze::cli {

/// A page of a recording, a picture each update: bodies as they came, moved and went, the contacts
/// of those that touch, and where pairs began and ended as the recording has it. Throws
/// RecordingError, and what repeating it throws.
ShownPage show_recording(const ViewOptions& options);

}  // namespace graze::cli
