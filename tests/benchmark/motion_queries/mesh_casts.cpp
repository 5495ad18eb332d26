#include "tests/benchmark/motion_queries/mesh_casts.h"

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/mesh_cast.h>
#include <graze/engine/mesh/prepare.h>
#include <graze/engine/mesh/volume_cast.h>
#include <graze/engine/world/shape_cast.h>

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
std::vector<MeshCastQuery> cast_queries(const Mesh& a, const Eigen::Vector3d& middle_of_b,
                                        double radius_of_b, int count) {
  RandomSource source(13);
  const double reach = radius_of(a) + radius_of_b;
  std::vector<MeshCastQuery> queries;
  while (static_cast<int>(queries.size()) < count) {
    const Eigen::Vector3d from = source.vector(-1, 1);
    if (from.norm() > 1 || from.norm() < 0.1) continue;
    const Eigen::Vector3d away = 1.5 * reach * from.normalized();
    const Eigen::Vector3d beside = radius_of(a) / 3 * source.vector(-1, 1);
    Pose pose = tests::random_pose(0, source);
    pose.translation() = middle_of(a) + away + beside - pose.linear() * middle_of_b;
    queries.push_back({pose, -2 * away});
  }
  return queries;
}

/// `ask(query, work)` tells whether there is a hit.
template <typename Ask>
MeshCastScore measure(const std::vector<MeshCastQuery>& queries, int repetitions, const Ask& ask) {
  MeshCastScore score;
  for (const MeshCastQuery& query : queries) {
    bool is_hit = ask(query, &score.work);
    std::vector<double> times;
    for (int i = 0; i < repetitions; ++i) {
      const ThreadClock clock;
      is_hit = ask(query, nullptr);
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

/// Prints a line, and adds an object to the rows.
void report(const std::string& name, std::size_t triangles, const MeshCastScore& score,
            nlohmann::ordered_json& rows) {
  if (score.hits.empty()) return;
  const double middle = median(score.hits), high = ninth_tenth(score.hits);
  const auto each = static_cast<double>(score.hits.size() + score.misses.size());
  std::printf("%-24s %16zu %6zu %10.1f %8.1f %12.0f %10.0f\n", name.c_str(), triangles,
              score.hits.size(), middle, high, static_cast<double>(score.work.volume_tests) / each,
              static_cast<double>(score.work.triangle_tests) / each);
  std::fflush(stdout);
  rows.push_back({{"pair", name},
                  {"hits", score.hits.size()},
                  {"median_us", middle},
                  {"p90_us", high},
                  {"misses", score.misses.size()},
                  {"miss_median_us", score.misses.empty() ? 0 : median(score.misses)}});
}

/// A ball, and a capsule of its size, of a seventh of the mesh's.
void measure_simple_casts(const std::string& name, int count, int repetitions,
                          nlohmann::ordered_json& rows) {
  const Mesh mesh = load_mesh(GRAZE_DATA_DIR "/meshes/" + name);
  prepare(mesh);
  const Shape shape = mesh;
  const double radius = 0.15 * radius_of(mesh);
  const Shape capsule = Capsule{radius / 2, radius / 2};
  const auto queries = cast_queries(mesh, {0, 0, 0}, radius, count);
  report(name + " ball", mesh.triangles().size(),
         measure(queries, repetitions,
                 [&](const MeshCastQuery& query, Work* work) {
                   const Sphere ball{query.pose.translation(), radius};
                   return cast({mesh}, ball, query.displacement, {}, work).has_value();
                 }),
         rows);
  report(name + " capsule", mesh.triangles().size(),
         measure(queries, repetitions,
                 [&](const MeshCastQuery& query, Work* work) {
                   const PlacedShapeView moving{capsule, query.pose};
                   return cast({shape}, moving, query.displacement, work).has_value();
                 }),
         rows);
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
    const auto ask = [&](const MeshCastQuery& query, Work* work) {
      return cast({a}, {b, query.pose}, query.displacement, {}, work).has_value();
    };
    report(std::string(names[0]) + " " + names[1], a.triangles().size() + b.triangles().size(),
           measure(cast_queries(a, middle_of(b), radius_of(b), queries), repetitions, ask), rows);
  }
  measure_simple_casts("bolt.obj", queries, repetitions, rows);
  return rows;
}

}  // namespace graze::benchmark
