#pragma once

#include <graze/engine/cli/commands/action.h>
#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace graze::cli {

/// Adds `graze compare`. Parsing it sets `action`; `arguments` are all that were given, for the
/// report.
void add_compare_command(CLI::App& program, Action& action,
                         const std::vector<std::string>& arguments);

}  // namespace graze::cli
