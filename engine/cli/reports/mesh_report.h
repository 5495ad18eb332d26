#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <graze/bvh/tree/statistics.h>
#include <graze/engine/cli/reports/level_report.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/fit.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/mesh_health.h>

namespace graze::cli {

/// Holds what `graze info` says of one mesh.
struct MeshReport {
  std::string file;
  std::size_t triangles;
  std::size_t vertices;  ///< the number of vertices as the file gives them
  Aabb bounds;
  Topology topology;
  bool has_fits;               ///< true if these two were asked for
  std::optional<MeshFit> fit;  ///< none also if a volume around the mesh overflows
  std::vector<LevelFit> levels;
  bvh::TreeStatistics tree;
  std::optional<std::size_t> self_intersections;  ///< their number, if it was asked for
  std::optional<MeshHealth> health;               ///< the faults, if they were asked for
  std::vector<mesh_io::Place> places;  ///< places of the triangles, if any of them is faulty
};

/// Says what to do: work that may take long is only done if it is asked for.
struct MeshReportSettings {
  bool has_fits = false;  ///< true to fit volumes around the mesh and around the nodes of its tree
  bool has_self_intersections = false;  ///< true to count the pairs of triangles that intersect
  bool has_health = false;              ///< true to say what is wrong with the mesh
  /// Called with how much is done, per cent.
  std::function<void(std::size_t per_cent)> on_progress = [](std::size_t) {};
};

/// Reads a mesh and reports on it. Throws MeshError if the file cannot be read.
MeshReport report_mesh(const std::string& file, const MeshReportSettings& settings);

/// Returns one JSON object on one line.
std::string to_json(const MeshReport& report);

/// Returns aligned lines for people.
std::string to_text(const MeshReport& report);

}  // namespace graze::cli
