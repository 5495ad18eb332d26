#pragma once

#include <graze/engine/cli/commands/action.h>
#include <CLI/App.hpp>

namespace graze::cli {

/// Adds `graze pair`. Parsing it sets `action`.
void add_pair_command(CLI::App& program, Action& action);

}  // namespace graze::cli
