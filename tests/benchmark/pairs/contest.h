#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tests/benchmark/pairs/builds.h"
#include "tests/benchmark/pairs/contestant.h"
#include "tests/benchmark/pairs/scene.h"

namespace graze::benchmark {

struct ContestSettings {
  int repetitions = 5;  ///< of each query
  BuildSettings build;
  std::size_t checked = 6;  ///< poses of each regime that brute force checks
  std::size_t most_for_peers =
      0;  ///< triangles of a mesh beyond which the library is alone; 0: none
};

/// How a contestant answered a question in the poses of a regime.
struct Score {
  std::string contestant;
  Question question;
  std::vector<double> microseconds;  ///< pose by pose
  std::size_t wrong = 0;             ///< poses with an answer that is not the default's
  std::optional<Work> work;          ///< summed over the poses, if it says
};

struct RegimeResult {
  std::string name;
  std::string source;
  std::size_t poses = 0;
  std::size_t checked = 0;  ///< of these, by brute force
  std::size_t hits = 0;     ///< poses in which the meshes intersect
  std::size_t pairs = 0;    ///< of triangles that do, in all poses
  std::vector<Score> scores;
};

struct BuildRow {
  std::string contestant;
  std::string refusal;  ///< why it takes no part here; empty if it does
  BuildMeasure measure;
};

struct SceneResult {
  std::string kind;
  std::string name;
  std::size_t triangles_a = 0;
  std::size_t triangles_b = 0;
  std::size_t mesh_bytes = 0;  ///< of both, vertices and indices alone
  double clearance = 0;        ///< metres, of "within"
  std::vector<BuildRow> builds;
  std::vector<RegimeResult> regimes;
};

/// The contest over one scene. Contestants take turns pose by pose, each pose begun by another. The
/// first contestant, the library's default, is the measure of all answers; in some poses it is
/// itself checked by brute force, and Error thrown if that differs.
SceneResult contest_over(const Scene& scene, PairContestants& contestants,
                         const ContestSettings& settings);

}  // namespace graze::benchmark
