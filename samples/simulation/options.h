#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace graze::samples {

/// What simulation_loop is asked for.
struct SimulationOptions {
  std::filesystem::path data;
  int bodies = 200;
  double seconds = 20;  ///< to simulate
  double shot = 30;     ///< metres a second: how fast a pellet comes at the end; 0 for none
  std::uint64_t seed = 1;
  std::filesystem::path gltf;  ///< empty for none
  std::filesystem::path picture;
  std::filesystem::path record;

  static constexpr const char* kUsage =
      "simulation_loop DATA_DIR [--bodies N] [--seconds S] [--shot M/S] [--seed K] "
      "[--gltf FILE] [--picture FILE.pov] [--record FILE]";
};

/// Nothing for a name that is none of these, or a value that is no number or out of range.
std::optional<SimulationOptions> simulation_options(int argc, char** argv);

}  // namespace graze::samples
