#pragma once

#include <graze/engine/cli/view/shown_pair.h>
#include <graze/engine/cli/view/view_run.h>

namespace graze::cli {

/// A page of cases, a picture each, or several where things move. What cannot be read is named on
/// stderr and left out; throws CaseError where nothing else is.
ShownPage show_cases(const ViewOptions& options);

}  // namespace graze::cli
