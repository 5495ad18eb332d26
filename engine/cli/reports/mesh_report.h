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

/// What `graze info` says of one mesh.
struct MeshReport {
  std::string file;
  std::size_t triangles;
  std::size_t vertices;  ///< as the file gives them
  Aabb bounds;
  Topology topology;
  bool has_fits;               ///< whether these two were asked for
  std::optional<MeshFit> fit;  ///< none, too, if a volume around the mesh overflows
  std::vector<LevelFit> levels;
  bvh::TreeStatistics tree;
  std::optional<std::size_t> self_intersections;  ///< if asked for
  std::optional<MeshHealth> health;               ///< if asked for
  std::vector<mesh_io::Place> places;             ///< of the triangles, if any of them is faulty
};

/// What may take long is only done if it is asked for.
struct MeshReportSettings {
  bool has_fits = false;  ///< volumes around the mesh and around the nodes of its tree
  bool has_self_intersections = false;  ///< count the pairs of triangles that intersect
  bool has_health = false;              ///< what is wrong with the mesh
  /// Called with how much is done, per cent.
  std::function<void(std::size_t per_cent)> on_progress = [](std::size_t) {};
};

/// Throws MeshError if the file cannot be read.
MeshReport report_mesh(const std::string& file, const MeshReportSettings& settings);

/// One JSON object on one line.
std::string to_json(const MeshReport& report);

/// Aligned lines for people.
std::string to_text(const MeshReport& report);

}  // namespace graze::cli
