#include <graze/engine/cli/reports/fit_report.h>
#include <graze/engine/cli/reports/health_report.h>
#include <graze/engine/cli/reports/mesh_report.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/io/format.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/self.h>

#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>

namespace graze::cli {
namespace {

nlohmann::ordered_json to_array(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

std::string to_words(const Eigen::Vector3d& v) {
  return fmt::format("{} {} {}", v.x(), v.y(), v.z());
}

void append(std::string& text, std::string_view name, const std::string& value) {
  fmt::format_to(std::back_inserter(text), "  {:<22}  {}\n", name, value);
}

nlohmann::ordered_json to_object(const bvh::TreeStatistics& tree) {
  return {{"nodes", tree.node_count},
          {"leaves", tree.leaf_count},
          {"depth", tree.depth},
          {"largest_leaf", tree.largest_leaf},
          {"mean_leaf", tree.mean_leaf_size},
          {"expected_node_visits", tree.expected_node_visits},
          {"expected_triangle_tests", tree.expected_primitive_tests},
          {"bytes", tree.bytes}};
}

void append(std::string& text, const bvh::TreeStatistics& tree) {
  append(text, "tree nodes", std::to_string(tree.node_count));
  append(text, "tree leaves", std::to_string(tree.leaf_count));
  append(text, "tree depth", std::to_string(tree.depth));
  append(text, "triangles per leaf",
         fmt::format("{:.2f} on average, at most {}", tree.mean_leaf_size, tree.largest_leaf));
  append(text, "line through the tree",
         fmt::format("{:.2f} nodes, {:.2f} triangles expected", tree.expected_node_visits,
                     tree.expected_primitive_tests));
  append(text, "tree bytes", std::to_string(tree.bytes));
}

std::optional<MeshFit> fit_of(const Mesh& mesh) {
  try {
    return measure_fit(mesh);
  } catch (const InputError&) {  // all meshes are finite, so that it can only be too large
    return std::nullopt;
  }
}

/// Reads where triangles stand, as only a mesh that has faults is worth reading once more. Returns
/// nothing if the file has changed.
std::vector<mesh_io::Place> places_in(const std::string& file, const Mesh& mesh) {
  std::vector<mesh_io::Place> places = mesh_io::find_triangle_places(file);
  if (places.size() != mesh.triangles().size()) places.clear();
  return places;
}

/// Tells how far the steps of a report have come.
class Steps {
 public:
  explicit Steps(const MeshReportSettings& settings)
      : settings_(settings), count_(1 + 2 * settings.has_fits + settings.has_health) {
    update(0);
  }

  /// Tells the share of the step that is being done, from 0 to 1.
  void update(double share) const {
    settings_.on_progress(static_cast<std::size_t>(100 * (done_ + share) / count_));
  }

  void end_one() {
    ++done_;
    update(0);
  }

 private:
  const MeshReportSettings& settings_;
  int count_;
  int done_ = 0;
};

}  // namespace

MeshReport report_mesh(const std::string& file, const MeshReportSettings& settings) {
  const Mesh mesh = load_mesh(file);
  Steps steps(settings);
  MeshReport report{.file = file,
                    .triangles = mesh.triangles().size(),
                    .vertices = mesh.vertices().size(),
                    .bounds = mesh.bounds(),
                    .topology = mesh.topology(),
                    .has_fits = settings.has_fits,
                    .fit = std::nullopt,
                    .levels = {},
                    .tree = bvh::statistics_of(tree_of(mesh)),
                    .self_intersections = std::nullopt,
                    .health = std::nullopt,
                    .places = {}};
  steps.end_one();
  if (settings.has_fits) {
    report.fit = fit_of(mesh);
    steps.end_one();
    report.levels = fit_by_level(mesh);
    steps.end_one();
  }
  if (settings.has_health) {
    report.health = check(mesh, {.on_progress = [&](std::size_t done, std::size_t total) {
                            steps.update(static_cast<double>(done) / static_cast<double>(total));
                          }});
    if (!report.health->is_healthy()) report.places = places_in(file, mesh);
    steps.end_one();
  }
  if (settings.has_self_intersections) {
    report.self_intersections =
        report.health ? report.health->self_intersections.size() : find_self_pairs(mesh).size();
  }
  return report;
}

std::string to_json(const MeshReport& report) {
  const Topology& topology = report.topology;
  nlohmann::ordered_json json;
  json["file"] = report.file;
  json["triangles"] = report.triangles;
  json["vertices"] = report.vertices;
  json["welded_vertices"] = topology.welded_vertices;
  json["bounds"]["min"] = to_array(report.bounds.min);
  json["bounds"]["max"] = to_array(report.bounds.max);
  json["size"] = to_array(report.bounds.max - report.bounds.min);
  json["closed"] = topology.is_closed;
  json["components"] = topology.components;
  json["boundary_edges"] = topology.boundary_edges;
  json["degenerate_triangles"] = topology.degenerate_triangles;
  json["duplicate_triangles"] = topology.duplicate_triangles;
  if (report.has_fits) {
    json["fit"] = report.fit ? fit_object(*report.fit) : nullptr;
    json["levels"] = levels_array(report.levels);
  }
  json["tree"] = to_object(report.tree);
  if (report.health) json["health"] = health_object(*report.health, report.places);
  if (report.self_intersections) json["self_intersections"] = *report.self_intersections;
  // File names need not be UTF-8, but JSON must be.
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string to_text(const MeshReport& report) {
  const Topology& topology = report.topology;
  std::string text = mesh_io::printable(report.file) + "\n";
  append(text, "triangles", std::to_string(report.triangles));
  append(text, "vertices", std::to_string(report.vertices));
  append(text, "welded vertices", std::to_string(topology.welded_vertices));
  append(text, "bounds min (m)", to_words(report.bounds.min));
  append(text, "bounds max (m)", to_words(report.bounds.max));
  append(text, "size (m)", to_words(report.bounds.max - report.bounds.min));
  append(text, "surface", topology.is_closed ? "closed" : "open");
  append(text, "components", std::to_string(topology.components));
  append(text, "boundary edges", std::to_string(topology.boundary_edges));
  append(text, "degenerate triangles", std::to_string(topology.degenerate_triangles));
  append(text, "duplicate triangles", std::to_string(topology.duplicate_triangles));
  if (report.has_fits) {
    for (const auto& [name, value] : fit_lines(report.fit))
      append(text, name, value);
  }
  append(text, report.tree);
  if (report.has_fits) text += levels_text(report.levels);
  if (report.health) {
    for (const auto& [name, value] : health_lines(*report.health, report.places))
      append(text, name, value);
  }
  if (report.self_intersections) {
    append(text, "self-intersections", std::to_string(*report.self_intersections));
  }
  return text;
}

}  // namespace graze::cli
