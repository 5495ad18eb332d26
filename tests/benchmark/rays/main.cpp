// Nanoseconds a ray at one mesh: the first hit, whether there is any, and many rays a call; rays
// that lie beside each other, as those of a picture do, and rays at random. Contestants take turns,
// the order changes each time, and medians are compared. Prints a table and writes JSON.

#include <graze/engine/mesh/load_mesh.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/benchmark/common/median.h"
#include "tests/benchmark/common/processor_name.h"
#include "tests/benchmark/common/thread_clock.h"
#include "tests/benchmark/rays/contestant.h"
#include "tests/benchmark/rays/scenes.h"

namespace graze::benchmark {
namespace {

using Contestants = std::vector<std::unique_ptr<RayContestant>>;

constexpr const char* kNames[] = {"first", "any", "batch"};

const char* name_of(Question question) {
  return kNames[static_cast<std::size_t>(question)];
}

nlohmann::json measure(Contestants& contestants, const std::string& mesh, const std::string& kind,
                       std::span<const Ray> rays, int rounds) {
  nlohmann::json rows;
  for (auto& contestant : contestants)
    contestant->take(rays);
  for (const Question question : kQuestions) {
    std::vector<std::vector<double>> times(contestants.size());
    std::vector<std::size_t> hits(contestants.size());
    for (int round = 0; round <= rounds; ++round) {
      for (std::size_t i = 0; i < contestants.size(); ++i) {
        const std::size_t who = (i + static_cast<std::size_t>(round)) % contestants.size();
        const ThreadClock clock;
        hits[who] = contestants[who]->ask(question);
        // The first round warms up.
        if (round > 0) times[who].push_back(clock.nanoseconds() / static_cast<double>(rays.size()));
      }
    }
    nlohmann::json row{{"mesh", mesh}, {"rays", kind}, {"question", name_of(question)}};
    std::printf("%-14s %-9s %-6s", mesh.c_str(), kind.c_str(), name_of(question));
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      const double time = median(times[i]);
      row[contestants[i]->name()] = {
          {"nanoseconds", time},
          {"hits", static_cast<double>(hits[i]) / static_cast<double>(rays.size())}};
      std::printf("  %s %7.1f", contestants[i]->name().c_str(), time);
    }
    if (contestants.size() == 2) {
      const double ratio = median(times[1]) / median(times[0]);
      row["speed"] = ratio;
      std::printf("  speed %.2f  hits %zu %zu", ratio, hits[0], hits[1]);
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
  CLI::App app("Nanoseconds a ray, beside Embree where it is found");
  std::string data = "data", output;
  std::vector<std::string> files;
  std::uint32_t large = 1000000;
  std::size_t rays = 1 << 16;
  int rounds = 9;
  app.add_option("--output", output, "JSON file");
  app.add_option("--data", data, "the project's data");
  app.add_option("--mesh", files, "more meshes");
  app.add_option("--large", large, "triangles of the made mesh");
  app.add_option("--rays", rays, "rays of each kind");
  app.add_option("--rounds", rounds, "repetitions");
  CLI11_PARSE(app, argc, argv);

  bench::Contestants contestants;
  contestants.push_back(bench::make_graze());
#ifdef GRAZE_HAS_EMBREE
  contestants.push_back(bench::make_embree());
#else
  std::puts("without Embree, which was not found");
#endif
  nlohmann::json rows = nlohmann::json::array();
  const auto all = [&](const std::string& name, const graze::Mesh& mesh) {
    for (auto& contestant : contestants)
      contestant->build(mesh);
    for (const auto& [kind, made] : {std::pair{"coherent", bench::coherent_rays(mesh, rays)},
                                     std::pair{"random", bench::random_rays(mesh, rays)}}) {
      for (const auto& row : bench::measure(contestants, name, kind, made, rounds))
        rows.push_back(row);
    }
  };
  for (const char* bundled : {"bolt.obj", "rock.ply", "terrain.ply"})
    files.push_back(data + "/meshes/" + bundled);
  for (const std::string& file : files)
    all(std::filesystem::path(file).stem().string(), graze::load_mesh(file));
  all("ball-" + std::to_string(large), bench::bumpy_ball(large));
  if (!output.empty()) {
    std::ofstream(output)
        << nlohmann::json{{"processor", bench::processor_name()}, {"rows", rows}}.dump(1) << '\n';
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
