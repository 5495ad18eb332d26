// Nanoseconds a point at one closed mesh: is it inside, what is nearest, both; points at random in
// a box around the mesh, and row by row on a grid. Contestants take turns, the order changes each
// time, and medians are compared. Prints a table and writes JSON.

#include <graze/engine/mesh/load_mesh.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "tests/benchmark/common/median.h"
#include "tests/benchmark/common/processor_name.h"
#include "tests/benchmark/common/thread_clock.h"
#include "tests/benchmark/points/contestant.h"
#include "tests/shapes/random_source.h"

namespace graze::benchmark {
namespace {

using Contestants = std::vector<std::unique_ptr<PointContestant>>;

constexpr const char* kNames[] = {"inside", "nearest", "signed", "batch"};

/// A tenth larger than the mesh on each side.
Aabb box_around(const Mesh& mesh) {
  const Eigen::Vector3d margin = 0.1 * (mesh.bounds().max - mesh.bounds().min);
  return {mesh.bounds().min - margin, mesh.bounds().max + margin};
}

Eigen::Vector3d point_at(const Aabb& box, double x, double y, double z) {
  return box.min + (box.max - box.min).cwiseProduct(Eigen::Vector3d(x, y, z));
}

std::vector<Eigen::Vector3d> random_points(const Mesh& mesh, std::size_t count) {
  RandomSource source(1);
  const Aabb box = box_around(mesh);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d share = source.vector(0, 1);
    points.push_back(point_at(box, share.x(), share.y(), share.z()));
  }
  return points;
}

std::vector<Eigen::Vector3d> grid_points(const Mesh& mesh, std::size_t count) {
  const Aabb box = box_around(mesh);
  const int n = static_cast<int>(std::cbrt(static_cast<double>(count)));
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < n * n * n; ++i)
    points.push_back(
        point_at(box, (i % n + 0.5) / n, (i / n % n + 0.5) / n, (i / n / n + 0.5) / n));
  return points;
}

nlohmann::json measure(Contestants& contestants, const std::string& mesh, const std::string& kind,
                       std::span<const Eigen::Vector3d> points, int rounds) {
  nlohmann::json rows;
  for (const PointQuestion question : kPointQuestions) {
    const char* name = kNames[static_cast<std::size_t>(question)];
    std::vector<std::vector<double>> times(contestants.size());
    std::vector<double> sums(contestants.size());
    for (int round = 0; round <= rounds; ++round) {
      for (std::size_t i = 0; i < contestants.size(); ++i) {
        const std::size_t who = (i + static_cast<std::size_t>(round)) % contestants.size();
        const ThreadClock clock;
        sums[who] = contestants[who]->ask(question, points);
        // The first round warms up.
        if (round > 0)
          times[who].push_back(clock.nanoseconds() / static_cast<double>(points.size()));
      }
    }
    nlohmann::json row{{"mesh", mesh}, {"points", kind}, {"question", name}};
    std::printf("%-8s %-7s %-8s", mesh.c_str(), kind.c_str(), name);
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      row[contestants[i]->name()] = {{"nanoseconds", median(times[i])}, {"sum", sums[i]}};
      std::printf("  %s %8.1f", contestants[i]->name().c_str(), median(times[i]));
    }
    if (contestants.size() == 2) {
      row["speed"] = median(times[1]) / median(times[0]);
      std::printf("  speed %6.2f  sums %.9g %.9g", row["speed"].get<double>(), sums[0], sums[1]);
    }
    std::puts("");
    rows.push_back(row);
  }
  return rows;
}

}  // namespace
}  // namespace graze::benchmark

int main(int argc, char** argv) try {
  namespace bench = graze::benchmark;
  CLI::App app("Nanoseconds a point, beside CGAL where it is found");
  std::string data = "data", output;
  std::vector<std::string> files;
  std::size_t points = 1 << 15;
  int rounds = 5;
  app.add_option("--output", output, "JSON file");
  app.add_option("--data", data, "the project's data");
  app.add_option("--mesh", files, "more meshes, which are closed");
  app.add_option("--points", points, "points of each kind");
  app.add_option("--rounds", rounds, "repetitions");
  CLI11_PARSE(app, argc, argv);

  bench::Contestants contestants;
  contestants.push_back(bench::make_graze_points());
#ifdef GRAZE_HAS_CGAL
  contestants.push_back(bench::make_cgal_points());
#else
  std::puts("without CGAL, which was not found");
#endif
  nlohmann::json rows = nlohmann::json::array();
  for (const char* bundled : {"bolt.obj", "gear.ply", "rock.ply"})
    files.push_back(data + "/meshes/" + bundled);
  for (const std::string& file : files) {
    const graze::Mesh mesh = graze::load_mesh(file);
    for (auto& contestant : contestants)
      contestant->build(mesh);
    for (const auto& [kind, made] : {std::pair{"random", bench::random_points(mesh, points)},
                                     std::pair{"grid", bench::grid_points(mesh, points)}}) {
      const std::string name = std::filesystem::path(file).stem().string();
      for (const auto& row : bench::measure(contestants, name, kind, made, rounds))
        rows.push_back(row);
    }
  }
  if (!output.empty()) {
    std::ofstream(output)
        << nlohmann::json{{"processor", bench::processor_name()}, {"rows", rows}}.dump(1) << '\n';
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
