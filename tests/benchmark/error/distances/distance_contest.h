#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/benchmark/error/elements.h"

namespace graze::benchmark {

/// How one contestant did in one category.
struct DistanceScore {
  double nanoseconds = 0;  ///< a query, median of the repetitions
  std::vector<double>
      errors;              ///< in ulps of the largest absolute placed coordinate, of those answered
  std::size_t failed = 0;  ///< not answered, or not with a number
  std::size_t false_zeros = 0;      ///< 0 although apart
  std::size_t false_distances = 0;  ///< more than 0 although touching
};

struct DistanceFacts {
  std::string name;
  bool is_generic;
  std::size_t elements;
  std::size_t touching;
};

/// All results of one question: scores[contestant][category].
struct DistanceResult {
  std::string question;
  std::vector<DistanceFacts> categories;
  std::vector<Label> labels;
  std::vector<std::vector<DistanceScore>> scores;
};

/// Counts an answer whose truth is known.
void count(DistanceScore& score, double answer, double truth, double ulp);

nlohmann::ordered_json to_json(const DistanceResult& result);

struct MeshDistanceSettings {
  std::filesystem::path data;  ///< folder of the bundled geometry
  std::size_t poses = 3;       ///< of each file
  int repetitions = 3;
};

/// Bundled meshes in their bundled poses. The truth is that of all pairs of triangles whose boxes
/// are as near as a pair that is known, by a sweep without any tree.
DistanceResult contest_of_mesh_distances(const MeshDistanceContestants& contestants,
                                         const MeshDistanceSettings& settings);

}  // namespace graze::benchmark
