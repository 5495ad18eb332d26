#include <graze/engine/cli/reports/fit_report.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace graze::cli {
namespace {

std::string row(const std::string& volume, const std::string& surface, const std::string& share) {
  return fmt::format("{:<12}  {:<13}  {}", volume, surface, share);
}

std::string share_of(const VolumeFit& fit) {
  if (fit.empty_share) return fmt::format("{:.1f}", 100 * *fit.empty_share);
  if (fit.relative_volume) return fmt::format("{:.3f}", *fit.relative_volume);
  return "-";
}

}  // namespace

nlohmann::ordered_json fit_object(const MeshFit& fit) {
  nlohmann::ordered_json json;
  if (fit.enclosed_volume) json["enclosed_volume"] = *fit.enclosed_volume;
  for (const VolumeFit& each : fit.volumes) {
    nlohmann::ordered_json& object = json[name_of(each.type)];
    object["volume"] = each.volume;
    object["surface"] = each.surface;
    if (each.empty_share) object["empty_per_cent"] = 100 * *each.empty_share;
    if (each.relative_volume) object["relative_to_aabb"] = *each.relative_volume;
  }
  return json;
}

std::vector<std::pair<std::string, std::string>> fit_lines(const std::optional<MeshFit>& fit) {
  if (!fit) return {{"bounding volumes", "too large for numbers"}};
  std::vector<std::pair<std::string, std::string>> lines;
  if (fit->enclosed_volume) {
    lines.push_back({"enclosed volume (m^3)", fmt::format("{:.6g}", *fit->enclosed_volume)});
  }
  lines.push_back({"bounding volumes", row("volume (m^3)", "surface (m^2)",
                                           fit->enclosed_volume ? "empty (%)" : "of aabb's")});
  for (const VolumeFit& each : fit->volumes) {
    lines.push_back({name_of(each.type), row(fmt::format("{:.6g}", each.volume),
                                             fmt::format("{:.6g}", each.surface), share_of(each))});
  }
  return lines;
}

}  // namespace graze::cli
