#pragma once

#include <graze/engine/cli/output/exit_code.h>
#include <graze/engine/cli/output/output.h>

#include <functional>

namespace graze::cli {

/// What the chosen subcommand does once all arguments are parsed.
using Action = std::function<ExitCode(Output&)>;

}  // namespace graze::cli
