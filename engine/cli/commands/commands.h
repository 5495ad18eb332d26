#pragma once

#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/output/output.h>
#include <CLI/App.hpp>

#include <functional>
#include <string>
#include <vector>

namespace graze::cli {

/// Does what the chosen subcommand does, once all arguments are parsed.
using Action = std::function<ExitCode(Output&)>;

/// Adds `graze pair`. Parsing it sets `action`.
void add_pair_command(CLI::App& program, Action& action);

/// Adds `graze contacts`. Parsing it sets `action`.
void add_contacts_command(CLI::App& program, Action& action);

/// Adds `graze motion`. Parsing it sets `action`.
void add_motion_command(CLI::App& program, Action& action);

/// Adds `graze verify`. Parsing it sets `action`.
void add_verify_command(CLI::App& program, Action& action);

/// Adds `graze voxels`. Parsing it sets `action`.
void add_voxels_command(CLI::App& program, Action& action);

/// Adds `graze info`. Parsing it sets `action`.
void add_info_command(CLI::App& program, Action& action);

/// Adds `graze explain`. Parsing it sets `action`.
void add_explain_command(CLI::App& program, Action& action);

/// Adds `graze simulate`. Parsing it sets `action`.
void add_simulate_command(CLI::App& program, Action& action);

/// Adds `graze compare`. Parsing it sets `action`; `arguments` are all that were given, for the
/// report.
void add_compare_command(CLI::App& program, Action& action,
                         const std::vector<std::string>& arguments);

/// Adds `graze merge`. Parsing it sets `action`.
void add_merge_command(CLI::App& program, Action& action);

/// Adds `graze replay`. Parsing it sets `action`.
void add_replay_command(CLI::App& program, Action& action);

/// Adds `graze scoreboard`. Parsing it sets `action`.
void add_scoreboard_command(CLI::App& program, Action& action);

/// Adds `graze view`, unless the command was built without pages. Parsing it sets `action`.
void add_view_command(CLI::App& program, Action& action);

/// Adds an option that may be given several times, each time with one value.
void add_repeated_option(CLI::App& command, const std::string& name,
                         std::vector<std::string>& values, const std::string& description,
                         const std::string& type);

/// Rewrites options that take a pose, or a screw, with the arguments that follow, be it one with
/// all numbers or one for each, as a single argument `--pose-a=...`: a parser of options then
/// cannot take negative numbers for options, nor meshes for numbers.
std::vector<std::string> join_pose_arguments(const std::vector<std::string>& arguments);

}  // namespace graze::cli
