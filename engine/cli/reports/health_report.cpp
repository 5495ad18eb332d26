#include <graze/engine/cli/reports/health_report.h>

#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace graze::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostListed = 1000;
constexpr std::size_t kMostTold = 3;

/// Holds a fault as the members of an object, as words, and its triangle.
struct FaultText {
  Json members;
  std::string words;
  std::uint32_t triangle;
};

FaultText text_of(const FaultyEdge& edge) {
  return {
      {{"vertices", edge.vertices},
       {"triangle", edge.triangle},
       {"triangle_count", edge.triangle_count}},
      fmt::format("edge {}-{} of triangle {}", edge.vertices[0], edge.vertices[1], edge.triangle),
      edge.triangle};
}

FaultText text_of(std::uint32_t triangle) {
  return {{{"triangle", triangle}}, fmt::format("triangle {}", triangle), triangle};
}

FaultText text_of(const DuplicateTriangle& duplicate) {
  return {{{"triangle", duplicate.triangle}, {"earlier", duplicate.earlier}},
          fmt::format("triangle {} is {}", duplicate.triangle, duplicate.earlier),
          duplicate.triangle};
}

FaultText text_of(const InsideOutPart& part) {
  return {
      {{"triangle", part.triangle}, {"triangle_count", part.triangle_count}, {"depth", part.depth}},
      fmt::format("the {} about triangle {}", part.triangle_count, part.triangle),
      part.triangle};
}

FaultText text_of(const TrianglePair& pair) {
  return {
      {{"triangle", pair.a}, {"other", pair.b}}, fmt::format("{} and {}", pair.a, pair.b), pair.a};
}

const char* name_of(mesh_io::Place::Unit unit) {
  return unit == mesh_io::Place::Unit::Line ? "line" : "byte";
}

template <typename Fault>
Json listed(const std::vector<Fault>& faults, const TrianglePlaces& places) {
  Json first = Json::array();
  for (std::size_t i = 0; i < std::min(faults.size(), kMostListed); ++i) {
    FaultText fault = text_of(faults[i]);
    if (!places.empty()) {
      const mesh_io::Place& place = places[fault.triangle];
      fault.members[name_of(place.unit)] = place.at;
    }
    first.push_back(std::move(fault.members));
  }
  return {{"count", faults.size()}, {"first", std::move(first)}};
}

template <typename Fault>
std::string told(const std::vector<Fault>& faults, const TrianglePlaces& places) {
  std::string text = std::to_string(faults.size());
  for (std::size_t i = 0; i < std::min(faults.size(), kMostTold); ++i) {
    const FaultText fault = text_of(faults[i]);
    text += (i == 0 ? ": " : ", ") + fault.words;
    if (places.empty()) continue;
    const mesh_io::Place& place = places[fault.triangle];
    text += fmt::format(" ({} {})", name_of(place.unit), place.at);
  }
  if (faults.size() > kMostTold) text += ", ...";
  return text;
}

}  // namespace

nlohmann::ordered_json health_object(const MeshHealth& health, const TrianglePlaces& places) {
  return {{"healthy", health.is_healthy()},
          {"open_edges", listed(health.open_edges, places)},
          {"non_manifold_edges", listed(health.non_manifold_edges, places)},
          {"turned_edges", listed(health.turned_edges, places)},
          {"degenerate_triangles", listed(health.degenerate_triangles, places)},
          {"duplicate_triangles", listed(health.duplicate_triangles, places)},
          {"inside_out_parts", listed(health.inside_out_parts, places)},
          {"self_intersections", listed(health.self_intersections.pairs, places)}};
}

std::vector<std::pair<std::string, std::string>> health_lines(const MeshHealth& health,
                                                              const TrianglePlaces& places) {
  return {{"health", health.is_healthy() ? "nothing is wrong" : "not healthy"},
          {"open edges", told(health.open_edges, places)},
          {"non-manifold edges", told(health.non_manifold_edges, places)},
          {"turned edges", told(health.turned_edges, places)},
          {"degenerate", told(health.degenerate_triangles, places)},
          {"duplicate", told(health.duplicate_triangles, places)},
          {"inside-out parts", told(health.inside_out_parts, places)},
          {"self-intersections", told(health.self_intersections.pairs, places)}};
}

}  // namespace graze::cli
