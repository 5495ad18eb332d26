#pragma once

#include <graze/engine/cli/commands/action.h>
#include <CLI/App.hpp>

namespace graze::cli {

/// Adds `graze voxels`. Parsing it sets `action`.
void add_voxels_command(CLI::App& program, Action& action);

}  // namespace graze::cli
