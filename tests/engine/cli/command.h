#pragma once

// Runs the graze command as its users do.

#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace graze::tests {

struct CommandResult {
  int exit_code = -1;  ///< -1 if a signal ended it
  std::string out;
  std::string err;
};

/// Runs the command in `folder`, so that messages name files as they are given here.
CommandResult run_graze(const std::filesystem::path& folder,
                        const std::vector<std::string>& arguments);

/// Starts the command, and sends it a signal as soon as `is_time` says so, of which it is asked
/// again and again while the command runs.
CommandResult interrupt_graze(const std::filesystem::path& folder,
                              const std::vector<std::string>& arguments,
                              const std::function<bool()>& is_time, int signal = SIGINT);

/// What a run takes of memory at most, in kB, of a process of its own; -1 if it fails. A run of a
/// process that is larger itself seems as large.
long peak_memory_of_graze(const std::filesystem::path& folder,
                          const std::vector<std::string>& arguments);

/// Runs a line of shell in `folder`, in which $GRAZE is the command.
CommandResult run_shell(const std::filesystem::path& folder, const std::string& line);

/// The lines of `text` without their ends.
std::vector<std::string> lines_of(const std::string& text);

}  // namespace graze::tests
