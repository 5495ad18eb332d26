#pragma once

#include <graze/engine/cli/commands/action.h>
#include <CLI/App.hpp>

namespace graze::cli {

/// Adds `graze explain`. Parsing it sets `action`.
void add_explain_command(CLI::App& program, Action& action);

}  // namespace graze::cli
