#include <graze/engine/cli/reports/health_report.h>

#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>

namespace graze::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostListed = 1000;
constexpr std::size_t kMostTold = 3;

Json to_json(const FaultyEdge& edge) {
  return {{"vertices", edge.vertices},
          {"triangle", edge.triangle},
          {"triangle_count", edge.triangle_count}};
}

Json to_json(std::uint32_t triangle) {
  return triangle;
}

Json to_json(const DuplicateTriangle& duplicate) {
  return {{"triangle", duplicate.triangle}, {"earlier", duplicate.earlier}};
}

Json to_json(const InsideOutPart& part) {
  return {
      {"triangle", part.triangle}, {"triangle_count", part.triangle_count}, {"depth", part.depth}};
}

Json to_json(const TrianglePair& pair) {
  return {pair.a, pair.b};
}

std::string to_words(const FaultyEdge& edge) {
  return fmt::format("edge {}-{} of triangle {}", edge.vertices[0], edge.vertices[1],
                     edge.triangle);
}

std::string to_words(std::uint32_t triangle) {
  return fmt::format("triangle {}", triangle);
}

std::string to_words(const DuplicateTriangle& duplicate) {
  return fmt::format("triangle {} is {}", duplicate.triangle, duplicate.earlier);
}

std::string to_words(const InsideOutPart& part) {
  return fmt::format("the {} about triangle {}", part.triangle_count, part.triangle);
}

std::string to_words(const TrianglePair& pair) {
  return fmt::format("{} and {}", pair.a, pair.b);
}

template <typename Fault>
Json listed(const std::vector<Fault>& faults) {
  Json first = Json::array();
  for (std::size_t i = 0; i < std::min(faults.size(), kMostListed); ++i)
    first.push_back(to_json(faults[i]));
  return {{"count", faults.size()}, {"first", std::move(first)}};
}

template <typename Fault>
std::string told(const std::vector<Fault>& faults) {
  std::string text = std::to_string(faults.size());
  for (std::size_t i = 0; i < std::min(faults.size(), kMostTold); ++i)
    text += (i == 0 ? ": " : ", ") + to_words(faults[i]);
  if (faults.size() > kMostTold) text += ", ...";
  return text;
}

}  // namespace

nlohmann::ordered_json health_object(const MeshHealth& health) {
  return {{"healthy", health.is_healthy()},
          {"open_edges", listed(health.open_edges)},
          {"non_manifold_edges", listed(health.non_manifold_edges)},
          {"turned_edges", listed(health.turned_edges)},
          {"degenerate_triangles", listed(health.degenerate_triangles)},
          {"duplicate_triangles", listed(health.duplicate_triangles)},
          {"inside_out_parts", listed(health.inside_out_parts)},
          {"self_intersections", listed(health.self_intersections.pairs)}};
}

std::vector<std::pair<std::string, std::string>> health_lines(const MeshHealth& health) {
  return {{"health", health.is_healthy() ? "nothing is wrong" : "not healthy"},
          {"open edges", told(health.open_edges)},
          {"non-manifold edges", told(health.non_manifold_edges)},
          {"turned edges", told(health.turned_edges)},
          {"degenerate", told(health.degenerate_triangles)},
          {"duplicate", told(health.duplicate_triangles)},
          {"inside-out parts", told(health.inside_out_parts)},
          {"self-intersections", told(health.self_intersections.pairs)}};
}

}  // namespace graze::cli
