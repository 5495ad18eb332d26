#pragma once

#include <graze/engine/cli/action.h>
#include <CLI/App.hpp>

namespace graze::cli {

/// Adds `graze compare`. Parsing it sets `action`.
void add_compare_command(CLI::App& program, Action& action);

}  // namespace graze::cli
