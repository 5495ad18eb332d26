#include <graze/engine/cli/reports/voxels_report.h>
#include <graze/engine/files/source.h>

#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>

namespace graze::cli {
namespace {

double fraction_of_grid(const VoxelsReport& report) {
  return static_cast<double>(report.voxels) / static_cast<double>(report.grid.size());
}

void append_field(std::string& text, std::string_view name, const std::string& value) {
  fmt::format_to(std::back_inserter(text), "  {:<22}  {}\n", name, value);
}

nlohmann::ordered_json to_object(const Work& work) {
  return {{"volume_tests", work.volume_tests},
          {"volume_rejections", work.volume_rejections},
          {"triangle_tests", work.triangle_tests},
          {"exact_tests", work.exact_tests},
          {"trees_built", work.trees_built}};
}

const char* name_of(VoxelFill fill) {
  return fill == VoxelFill::Solid ? "solid" : "surface";
}

}  // namespace

std::string to_json(const VoxelsReport& report) {
  const Eigen::Vector3d& origin = report.grid.origin;
  nlohmann::ordered_json json;
  json["mesh"] = report.mesh;
  json["file"] = report.file;
  json["fill"] = name_of(report.fill);
  json["counts"] = report.grid.counts;
  json["edge"] = report.grid.edge;
  json["origin"] = {origin.x(), origin.y(), origin.z()};
  json["voxels"] = report.voxels;
  json["fraction"] = fraction_of_grid(report);
  json["find_ms"] = report.find_time.count() * 1000;
  json["write_ms"] = report.write_time.count() * 1000;
  json["work"] = to_object(report.work);
  // File names need not be UTF-8, but JSON must be.
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string to_text(const VoxelsReport& report) {
  const VoxelGrid& grid = report.grid;
  std::string text = mesh_io::printable(report.file) + "\n";
  append_field(text, "grid",
               fmt::format("{} x {} x {}", grid.counts[0], grid.counts[1], grid.counts[2]));
  append_field(text, "voxel edge (m)", fmt::format("{}", grid.edge));
  append_field(text, "origin (m)",
               fmt::format("{} {} {}", grid.origin.x(), grid.origin.y(), grid.origin.z()));
  append_field(text, "voxels", fmt::format("{} ({})", report.voxels, name_of(report.fill)));
  append_field(text, "of the grid", fmt::format("{:.4g} %", 100 * fraction_of_grid(report)));
  append_field(
      text, "triangle tests",
      fmt::format("{}, {} of them exact", report.work.triangle_tests, report.work.exact_tests));
  append_field(text, "time to find (ms)", fmt::format("{:.1f}", report.find_time.count() * 1000));
  append_field(text, "time to write (ms)", fmt::format("{:.1f}", report.write_time.count() * 1000));
  return text;
}

}  // namespace graze::cli
