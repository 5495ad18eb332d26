#pragma once

// Hard cases with their truth (data/hard_cases) before an engine of your own, without graze: copy
// this header, which needs nlohmann-json alone, and call hard_cases::scoreboard().

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace hard_cases {

using Json = nlohmann::json;

/// An answer as the case's own is written, {{"says", true}}; none for what the engine has no query
/// for.
using Answer = std::function<std::optional<Json>(const Json& query)>;

/// A triangle or a mesh in its place.
struct PlacedMesh {
  std::vector<std::array<double, 3>> vertices;  ///< metres
  std::vector<std::array<std::size_t, 3>> triangles;
};

/// None for other shapes, and for what moves.
inline std::optional<PlacedMesh> mesh_of(const Json& shape) {
  if (shape.contains("triangle")) return PlacedMesh{shape.at("triangle"), {{0, 1, 2}}};
  if (!shape.contains("mesh") || shape.contains("motion")) return std::nullopt;
  const Json& mesh = shape.at("mesh");
  const std::array<double, 12> r = shape.at("pose");
  PlacedMesh placed{mesh.at("vertices"), mesh.at("triangles")};
  for (auto& v : placed.vertices) {
    const std::array<double, 3> p = v;
    for (std::size_t i = 0; i < 3; ++i)
      v[i] = ((r[4 * i] * p[0] + r[4 * i + 1] * p[1]) + r[4 * i + 2] * p[2]) + r[4 * i + 3];
  }
  return placed;
}

/// The largest number in it.
inline double largest(const Json& value) {
  double result = value.is_number() ? std::abs(value.get<double>()) : 0;
  if (value.is_structured())
    for (const Json& each : value)
      result = std::max(result, largest(each));
  return result;
}

inline bool is_near(const Json& said, const Json& truth, double scale) {
  return said == truth || std::abs(said.get<double>() - truth.get<double>()) <= scale;
}

/// Whether an answer says the same as the case's own.
inline bool passes(const Json& query, const Json& said) {
  const Json& truth = query.at("answer");
  const double scale = 1e-9 * std::max(largest(query.at("a")), largest(query.at("b")));
  for (const char* key : {"says", "pairs"})
    if (truth.contains(key)) return said.at(key) == truth.at(key);
  if (truth.contains("distance")) return is_near(said.at("distance"), truth.at("distance"), scale);
  if (truth.contains("hits")) {
    const Json& hits = truth.at("hits");
    if (said.at("hits").size() != hits.size()) return false;
    for (std::size_t i = 0; i < hits.size(); ++i)
      if (!is_near(said.at("hits")[i].at("distance"), hits[i].at("distance"), scale)) return false;
    return true;
  }
  return said.at("status") == truth.at("status") &&
         is_near(said.at("high"), truth.at("high"), 1e-3);
}

struct Row {
  int passed = 0;
  int failed = 0;
  int refused = 0;
};

/// Puts each case to the engine. A class is the name of a file; what throws has failed.
inline std::map<std::string, Row> score(const std::filesystem::path& folder, const Answer& answer) {
  std::map<std::string, Row> rows;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".jsonl") continue;
    Row& row = rows[entry.path().stem().string()];
    std::ifstream file(entry.path());
    if (!file) throw std::runtime_error(entry.path().string() + ": cannot be read");
    for (std::string line; std::getline(file, line);) {
      const Json query = Json::parse(line);
      try {
        const std::optional<Json> said = answer(query);
        ++(!said ? row.refused : passes(query, *said) ? row.passed : row.failed);
      } catch (const std::exception&) {
        ++row.failed;
      }
    }
  }
  return rows;
}

/// The same as a table on the standard output.
inline void scoreboard(const std::filesystem::path& folder, const Answer& answer) {
  std::printf("%14s%8s%8s%8s\n", "class", "passed", "failed", "refused");
  Row all;
  for (const auto& [kind, row] : score(folder, answer)) {
    std::printf("%14s%8d%8d%8d\n", kind.c_str(), row.passed, row.failed, row.refused);
    all = {all.passed + row.passed, all.failed + row.failed, all.refused + row.refused};
  }
  std::printf("%14s%8d%8d%8d\n", "all", all.passed, all.failed, all.refused);
}

}  // namespace hard_cases
