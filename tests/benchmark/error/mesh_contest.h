#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tests/benchmark/error/mesh_contestant.h"
#include "tests/benchmark/error/report.h"

namespace graze::benchmark {

struct MeshSettings {
  std::string data;        ///< folder of the bundled geometry
  std::size_t poses = 12;  ///< of each file, spread evenly
  int repetitions = 5;
};

/// Two questions about all bundled poses of the bundled meshes: do any triangles intersect, and
/// which. An element of the second is a pair of triangles whose boxes share a point; all else is
/// per query: its time is that of all pairs of a pose.
std::vector<QuestionResult> contest_of_meshes(const MeshContestants& contestants,
                                              const MeshSettings& settings);

}  // namespace graze::benchmark
