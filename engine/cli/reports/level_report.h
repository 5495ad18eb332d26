#pragma once

#include <optional>
#include <string>
#include <vector>

#include <graze/engine/mesh/mesh.h>
#include <nlohmann/json_fwd.hpp>

namespace graze::cli {

/// Says how well volumes fit the nodes at one distance from the root of a tree. Below a node lies
/// an open patch of surface, so that volumes are relative to those of the boxes; there is none
/// where all boxes are flat or their volume overflows.
struct LevelFit {
  std::size_t nodes;
  double aabb_volume;  ///< m^3, the sum over the nodes
  std::optional<double> sphere;
  std::optional<double> obb;
  std::optional<double> kdop;
};

/// Returns the fits from the root down.
std::vector<LevelFit> fit_by_level(const Mesh& mesh);

nlohmann::ordered_json levels_array(const std::vector<LevelFit>& levels);

/// Returns a table for people.
std::string levels_text(const std::vector<LevelFit>& levels);

}  // namespace graze::cli
