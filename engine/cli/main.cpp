#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/cli/commands/commands.h>
#include <graze/engine/cli/files/removal_on_signal.h>
#include <graze/engine/cli/output/interruption.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/output/output.h>
#include <graze/engine/files/source.h>
#include <graze/engine/version.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

namespace graze::cli {
namespace {

constexpr const char* kFooter = R"(
Each subcommand has its own --help.

Examples:
  graze info bolt.obj nut.stl
  graze pair bolt.obj nut.stl --pose-b "1 0 0 0  0 1 0 0  0 0 1 0.002"
  graze contacts bolt.obj nut.stl --separate
  graze motion bolt.obj nut.stl --path poses.txt --json
  graze voxels bolt.obj --resolution 200 -o voxels.ply
  graze simulate scene.json --contacts
  graze compare bolt.obj nut.stl --grazing 100 --report out.html
  graze explain bolt.obj nut.stl
  graze view bolt.obj nut.stl --poses poses.txt -o page.html

Meshes are read from OBJ, STL, PLY and OFF files, by their names' endings. Lengths are in metres.

Exit codes:
  0  an answer was given, whatever it is
  1  with --check, compare or replay: exact arithmetic found an answer of graze to be wrong, or one that
     replay --fail-on names; with verify: what the file holds is no proof
  2  bad input, with one line on stderr
  130  compare --resume was interrupted; stderr says how to go on)";

ExitCode refuse(const std::string& message) {
  std::fprintf(stderr, "graze: %s\n", mesh_io::printable(message).c_str());
  return ExitCode::BadInput;
}

std::string usage_hint(const CLI::App& program) {
  const auto chosen = program.get_subcommands();
  return chosen.empty() ? " (see graze --help)"
                        : " (see graze " + chosen[0]->get_name() + " --help)";
}

/// Refuses arguments without a subcommand. CLI11 would say that one is required, which hides that
/// one was given.
void check_subcommand(const CLI::App& program, const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments[0].starts_with('-')) return;
  const auto is_named = [&](const CLI::App* command) { return command->check_name(arguments[0]); };
  if (program.get_subcommands(is_named).empty()) {
    throw UsageError("there is no subcommand " + mesh_io::quoted(arguments[0]) +
                     " (see graze --help)");
  }
}

ExitCode parse_and_run(CLI::App& program, std::vector<std::string> arguments, const Action& action,
                       Output& output) {
  check_subcommand(program, arguments);
  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them in this order
  try {
    program.parse(arguments);
  } catch (const CLI::CallForHelp&) {
    output.write(program.help());
    return ExitCode::Answered;
  } catch (const CLI::CallForVersion&) {
    output.write(program.version() + "\n");
    return ExitCode::Answered;
  } catch (const CLI::ParseError& error) {
    return refuse(error.what() + usage_hint(program));
  }
  return action(output);
}

ExitCode run(const std::vector<std::string>& arguments) {
  CLI::App program("Exact collision queries between triangle meshes", "graze");
  program.set_version_flag("--version", std::string("graze ") + graze::library_version());
  program.require_subcommand(1);
  program.footer(kFooter);
  Action action;
  add_info_command(program, action);
  add_pair_command(program, action);
  add_contacts_command(program, action);
  add_motion_command(program, action);
  add_verify_command(program, action);
  add_voxels_command(program, action);
  add_simulate_command(program, action);
  add_replay_command(program, action);
  add_scoreboard_command(program, action);
  add_merge_command(program, action);
  add_compare_command(program, action, arguments);
  add_explain_command(program, action);
  add_view_command(program, action);
  Output output(stdout);
  try {
    return parse_and_run(program, join_pose_arguments(arguments), action, output);
  } catch (const OutputClosed&) {
    return ExitCode::Answered;  // the reader has all that it wanted
  } catch (const Interrupted& stopped) {
    refuse(stopped.what());
    return ExitCode::Interrupted;
  } catch (const std::bad_alloc&) {
    return refuse("out of memory");
  } catch (const std::exception& error) {
    return refuse(error.what());
  }
}

}  // namespace
}  // namespace graze::cli

int main(int argc, char** argv) {
  graze::cli::reserve_standard_streams();
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error of write(), not a death
  graze::cli::remove_temporary_files_on_signals();
  // A library of another engine that was linked with -ffast-math flushes denormal numbers for the
  // whole program as it is loaded, and the command computes for itself, too. Threads take after the
  // one that starts them.
  return static_cast<int>(graze::bvh::in_standard_arithmetic([&] {
    return graze::cli::run({argv + 1, argv + argc});
  }));
}
