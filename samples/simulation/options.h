#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace graze::samples {

/// Holds what simulation_loop is asked for.
struct SimulationOptions {
  std::filesystem::path data;
  int bodies = 200;
  double seconds = 20;  ///< seconds to simulate
  double shot = 30;     ///< metres a second at which a pellet comes at the end; 0 for no pellet
  std::uint64_t seed = 1;
  std::filesystem::path gltf;  ///< empty for no such file
  std::filesystem::path picture;
  std::filesystem::path record;

  static constexpr const char* kUsage =
      "simulation_loop DATA_DIR [--bodies N] [--seconds S] [--shot M/S] [--seed K] "
      "[--gltf FILE] [--picture FILE.pov] [--record FILE]";
};

/// Returns nothing for a name that is not among these, or a value that is not a number or out of
/// range.
std::optional<SimulationOptions> simulation_options(int argc, char** argv);

}  // namespace graze::samples
