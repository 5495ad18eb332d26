#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <graze/bvh/tree/statistics.h>
#include <graze/engine/cli/reports/level_report.h>
#include <graze/engine/mesh/fit.h>
#include <graze/engine/mesh/mesh.h>

namespace graze::cli {

/// What `graze info` says of one mesh.
struct MeshReport {
  std::string file;
  std::size_t triangles;
  std::size_t vertices;  ///< as the file gives them
  Aabb bounds;
  Topology topology;
  std::optional<MeshFit> fit;  ///< none if a volume around the mesh overflows
  std::vector<LevelFit> levels;
  bvh::TreeStatistics tree;
  std::optional<std::size_t> crossing_pairs;  ///< if asked for
};

struct MeshReportSettings {
  bool has_crossing_pairs = false;  ///< count the pairs of triangles that cross: may take long
};

/// Throws MeshError if the file cannot be read.
MeshReport report_mesh(const std::string& file, const MeshReportSettings& settings);

/// One JSON object on one line.
std::string to_json(const MeshReport& report);

/// Aligned lines for people.
std::string to_text(const MeshReport& report);

}  // namespace graze::cli
