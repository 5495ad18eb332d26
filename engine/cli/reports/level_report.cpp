#include <graze/bvh/skins/level_volumes.h>
#include <graze/bvh/tree/tree.h>
#include <graze/engine/cli/reports/level_report.h>
#include <graze/engine/mesh/data/mesh_trees.h>

#include <fmt/format.h>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

namespace graze::cli {
namespace {

std::optional<double> ratio(double volume, double of_boxes) {
  const double quotient = volume / of_boxes;  // not a number for flat boxes, or for huge ones
  return std::isfinite(quotient) ? std::optional(quotient) : std::nullopt;
}

std::string to_word(const std::optional<double>& ratio) {
  return ratio ? fmt::format("{:.4g}", *ratio) : "-";
}

nlohmann::ordered_json to_value(const std::optional<double>& ratio) {
  return ratio ? nlohmann::ordered_json(*ratio) : nlohmann::ordered_json(nullptr);
}

}  // namespace

std::vector<LevelFit> fit_by_level(const Mesh& mesh) {
  const bvh::Tree& tree = tree_of(mesh);
  const auto boxes = bvh::volumes_by_level(tree);
  const auto spheres = bvh::volumes_by_level(tree, sphere_skin_of(mesh));
  const auto obbs = bvh::volumes_by_level(tree, obb_skin_of(mesh));
  const auto kdops = bvh::volumes_by_level(tree, kdop_skin_of(mesh));
  std::vector<LevelFit> levels;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const double of_boxes = boxes[i].volume;
    levels.push_back({boxes[i].nodes, of_boxes, ratio(spheres[i].volume, of_boxes),
                      ratio(obbs[i].volume, of_boxes), ratio(kdops[i].volume, of_boxes)});
  }
  return levels;
}

nlohmann::ordered_json levels_array(const std::vector<LevelFit>& levels) {
  nlohmann::ordered_json array = nlohmann::ordered_json::array();
  for (const LevelFit& level : levels) {
    array.push_back({{"nodes", level.nodes},
                     {"aabb_volume", level.aabb_volume},
                     {"sphere", to_value(level.sphere)},
                     {"obb", to_value(level.obb)},
                     {"kdop", to_value(level.kdop)}});
  }
  return array;
}

std::string levels_text(const std::vector<LevelFit>& levels) {
  std::string text =
      fmt::format("  {:<22}  {:<8}  {:>14}  {:>8}  {:>8}  {:>8}\n", "level of the tree", "nodes",
                  "aabbs (m^3)", "sphere", "obb", "kdop");
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const LevelFit& level = levels[i];
    fmt::format_to(std::back_inserter(text), "  {:<22}  {:<8}  {:>14.6g}  {:>8}  {:>8}  {:>8}\n", i,
                   level.nodes, level.aabb_volume, to_word(level.sphere), to_word(level.obb),
                   to_word(level.kdop));
  }
  return text;
}

}  // namespace graze::cli
