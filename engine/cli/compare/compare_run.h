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

/// Cases go into this folder if no other is named. A run that finds it read-only goes on.
inline constexpr const char* kDefaultCases = "graze-cases";

/// Holds the arguments of `graze compare` as they are given.
struct CompareOptions {
  std::string mesh_a;  ///< a mesh, or a folder of cases, or a scene
  std::string mesh_b;
  std::string pose_a;
  std::string pose_b;
  std::optional<std::string> poses;
  std::size_t random = 0;
  std::size_t grazing = 0;
  std::optional<std::uint64_t> seed;
  std::string query = "any";
  double clearance = -1;  ///< metres, for --query within
  std::string engines;    ///< names with commas; empty for all
  std::string cases;      ///< the folder where shrunk cases go; empty for the default folder
  std::size_t keep = 16;  ///< the number of cases to keep
  std::string report;     ///< an HTML file
  std::string save;
  std::string against;
  std::string resume;
  double time_tolerance = 1.5;
  double answer_tolerance = 0;  ///< the tolerance of --against: metres, or shares of a motion
  std::string part = {};        ///< "K/N"; empty for the whole job
  std::vector<std::string> answers = {};  ///< files of recorded answers, which take part as well
  std::size_t threads = 0;
  double timeout = 60;  ///< seconds for each question to another engine
  // The following options are for scenes alone.
  std::optional<std::size_t> steps = {};
  double step = 0;               ///< seconds; 0 for the scene's own step
  std::string mesh_folder = {};  ///< the folder of meshes; empty for that of the scene
  bool is_json = false;
  bool has_progress = false;
  double shrink_seconds = 10;                     ///< seconds for all cases
  std::string command = {};                       ///< the line that was typed, for the report
  std::vector<std::string> engine_commands = {};  ///< commands, each of which starts an engine of
                                                  ///< the user's own
  std::vector<std::string> fail_on = {};  ///< says whose wrong answers fail the run (FailOn)
  std::string junit = {};                 ///< an XML file for programs that run tests
  std::string markdown = {};              ///< a file for a code host's summary
};

/// Says how other engines are asked.
inline compare::PeerSettings peer_settings(const CompareOptions& options) {
  return {.timeout = std::chrono::duration<double>(options.timeout)};
}

/// Compares `known` engines, and those of compare::motion_engines() that are named. Throws
/// UsageError, PoseError, MeshError or CaseError. Bad input leaves standard output empty.
ExitCode run_compare(const CompareOptions& options, std::span<const compare::EngineEntry> known,
                     Output& output);

/// Runs `graze compare FOLDER`, for a folder of cases, each of which says what is asked. Throws
/// UsageError for options of meshes and scenes, CaseError for an invalid case.
ExitCode run_compare_folder(const CompareOptions& options,
                            std::span<const compare::EngineEntry> engines, Output& output);

/// Runs `graze compare SCENE`. Throws UsageError for options of meshes, SceneError for an invalid
/// scene, PoseError for paths that lead beyond what a world can hold.
ExitCode run_compare_scene(const CompareOptions& options,
                           std::span<const compare::EngineEntry> engines, Output& output);

}  // namespace graze::cli
