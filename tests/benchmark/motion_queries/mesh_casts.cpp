#include "tests/benchmark/motion_queries/mesh_casts.h"

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/mesh_cast.h>
#include <graze/engine/mesh/prepare.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/benchmark/common/median.h"
#include "tests/benchmark/common/thread_clock.h"
#include "tests/shapes/random_meshes.h"

namespace graze::benchmark {
namespace {

struct MeshCastQuery {
  Pose pose;
  Eigen::Vector3d displacement;
};

struct MeshCastScore {
  std::vector<double> hits;    ///< microseconds, of each query the median
  std::vector<double> misses;  ///< likewise
  Work work;
};

Eigen::Vector3d middle_of(const Mesh& mesh) {
  return 0.5 * (mesh.bounds().min + mesh.bounds().max);
}

double radius_of(const Mesh& mesh) {
  return 0.5 * (mesh.bounds().max - mesh.bounds().min).norm();
}

/// One and a half of both radii away, past A's middle by up to a third of its radius.
std::vector<MeshCastQuery> cast_queries(const Mesh& a, const Mesh& b, int count) {
  RandomSource source(13);
  const double reach = radius_of(a) + radius_of(b);
  std::vector<MeshCastQuery> queries;
  while (static_cast<int>(queries.size()) < count) {
    const Eigen::Vector3d from = source.vector(-1, 1);
    if (from.norm() > 1 || from.norm() < 0.1) continue;
    const Eigen::Vector3d away = 1.5 * reach * from.normalized();
    const Eigen::Vector3d beside = radius_of(a) / 3 * source.vector(-1, 1);
    Pose pose = tests::random_pose(0, source);
    pose.translation() = middle_of(a) + away + beside - pose.linear() * middle_of(b);
    queries.push_back({pose, -2 * away});
  }
  return queries;
}

MeshCastScore measure(const Mesh& a, const Mesh& b, int count, int repetitions) {
  MeshCastScore score;
  for (const MeshCastQuery& query : cast_queries(a, b, count)) {
    bool is_hit = cast({a}, {b, query.pose}, query.displacement, {}, &score.work).has_value();
    std::vector<double> times;
    for (int i = 0; i < repetitions; ++i) {
      const ThreadClock clock;
      is_hit = cast({a}, {b, query.pose}, query.displacement).has_value();
      times.push_back(clock.nanoseconds() * 1e-3);
    }
    (is_hit ? score.hits : score.misses).push_back(median(times));
  }
  return score;
}

double ninth_tenth(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() * 9 / 10];
}

}  // namespace

nlohmann::ordered_json measure_mesh_casts(int queries, int repetitions) {
  constexpr const char* kPairs[][2] = {{"gear.ply", "pinion.off"},
                                       {"nut.stl", "bolt.obj"},
                                       {"rock.ply", "nut.stl"},
                                       {"terrain.ply", "rock.ply"}};
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  std::printf("\n%-24s %16s %6s %10s %8s %12s %10s\n", "cast", "triangles", "hits", "median us",
              "p90 us", "box tests", "triangles");
  for (const auto& names : kPairs) {
    const std::string folder = GRAZE_DATA_DIR "/meshes/";
    const Mesh a = load_mesh(folder + names[0]), b = load_mesh(folder + names[1]);
    prepare(a), prepare(b);
    const MeshCastScore score = measure(a, b, queries, repetitions);
    if (score.hits.empty()) continue;
    const double middle = median(score.hits), high = ninth_tenth(score.hits);
    const std::string name = std::string(names[0]) + " " + names[1];
    const auto each = static_cast<double>(queries);
    std::printf("%-24s %7zu %8zu %6zu %10.1f %8.1f %12.0f %10.0f\n", name.c_str(),
                a.triangles().size(), b.triangles().size(), score.hits.size(), middle, high,
                static_cast<double>(score.work.volume_tests) / each,
                static_cast<double>(score.work.triangle_tests) / each);
    std::fflush(stdout);
    rows.push_back({{"pair", name},
                    {"hits", score.hits.size()},
                    {"median_us", middle},
                    {"p90_us", high},
                    {"misses", score.misses.size()},
                    {"miss_median_us", score.misses.empty() ? 0 : median(score.misses)}});
  }
  return rows;
}

}  // namespace graze::benchmark
