#pragma once

#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/output/output.h>
#include <graze/engine/compare/peers/engine.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace graze::cli {

/// Where cases go if no folder is named. A run that finds it read-only goes on.
inline constexpr const char* kDefaultCases = "graze-cases";

/// The arguments of `graze compare` as they are given.
struct CompareOptions {
  std::string mesh_a;  ///< or a folder of cases, or a scene
  std::string mesh_b;
  std::string pose_a;
  std::string pose_b;
  std::optional<std::string> poses;
  std::size_t random = 0;
  std::size_t grazing = 0;
  std::optional<std::uint64_t> seed;
  std::string query = "any";
  double clearance = -1;  ///< metres, of --query within
  std::string engines;    ///< names with commas; empty: all
  std::string cases;      ///< where shrunk cases go; empty: the default folder
  std::size_t keep = 16;  ///< so many of them
  std::string report;     ///< an HTML file
  std::string save;
  std::string against;
  std::string resume;
  double time_tolerance = 1.5;
  double answer_tolerance = 0;            ///< of --against: metres, or shares of a motion
  std::string part = {};                  ///< "K/N"; empty: the whole job
  std::vector<std::string> answers = {};  ///< files of recorded answers, which take part
  std::size_t threads = 0;
  double timeout = 60;  ///< seconds, of each question to another engine
  // Of scenes alone:
  std::optional<std::size_t> steps = {};
  double step = 0;               ///< seconds; 0: as the scene says
  std::string mesh_folder = {};  ///< empty: that of the scene
  bool is_json = false;
  bool has_progress = false;
  double shrink_seconds = 10;                     ///< for all cases
  std::string command = {};                       ///< the line that was typed, for the report
  std::vector<std::string> engine_commands = {};  ///< each starts an engine of the user's own
  std::vector<std::string> fail_on = {};          ///< whose wrong answers fail the run (FailOn)
  std::string junit = {};                         ///< an XML file for what runs tests
  std::string markdown = {};                      ///< a file for a code host's summary
};

/// How other engines are asked.
inline compare::PeerSettings peer_settings(const CompareOptions& options) {
  return {.timeout = std::chrono::duration<double>(options.timeout)};
}

/// `known` take part, and those of compare::motion_engines() that are named.
/// Throws UsageError, PoseError, MeshError or CaseError. Bad input leaves standard output empty.
ExitCode run_compare(const CompareOptions& options, std::span<const compare::EngineEntry> known,
                     Output& output);

/// `graze compare FOLDER`, of cases, each of which says what is asked. Throws UsageError for
/// options of meshes and scenes, CaseError for what is no case.
ExitCode run_compare_folder(const CompareOptions& options,
                            std::span<const compare::EngineEntry> engines, Output& output);

/// `graze compare SCENE`. Throws UsageError for options of meshes, SceneError for what is no scene,
/// PoseError for paths that lead beyond what a world can hold.
ExitCode run_compare_scene(const CompareOptions& options,
                           std::span<const compare::EngineEntry> engines, Output& output);

}  // namespace graze::cli
