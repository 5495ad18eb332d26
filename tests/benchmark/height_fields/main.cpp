// Microseconds for a body on a terrain, and for a ray: a height field, the mesh that it is, and
// Bullet's height field. Contestants take turns; medians. Prints a table and writes JSON.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/benchmark/common/median.h"
#include "tests/benchmark/common/processor_name.h"
#include "tests/benchmark/common/thread_clock.h"
#include "tests/benchmark/height_fields/contestant.h"

namespace graze::benchmark {

namespace {

using Contestants = std::vector<std::unique_ptr<FieldContestant>>;

nlohmann::json measure(Contestants& contestants, std::uint32_t side, std::size_t bodies,
                       std::size_t rays, int rounds) {
  const Terrain terrain = make_terrain(side, bodies, rays);
  const double cells = (side - 1.0) * (side - 1.0);
  nlohmann::json row{{"cells", cells}, {"bodies", bodies}, {"rays", rays}};
  for (auto& contestant : contestants) {
    const ThreadClock clock;
    const std::size_t bytes = contestant->build(terrain);
    row[contestant->name()]["build_ms"] = clock.nanoseconds() * 1e-6;
    row[contestant->name()]["bytes_per_cell"] = static_cast<double>(bytes) / cells;
    contestant->place(terrain);
  }
  std::vector<std::vector<double>> steps(contestants.size()), casts(contestants.size());
  std::vector<std::size_t> touching(contestants.size()), hits(contestants.size());
  for (int round = 0; round <= rounds; ++round) {
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      const std::size_t who = (i + static_cast<std::size_t>(round)) % contestants.size();
      touching[who] = 0;
      for (const std::vector<Pose>& frame : terrain.frames) {
        const ThreadClock clock;
        touching[who] += contestants[who]->step(frame);
        if (round > 0)
          steps[who].push_back(1e-3 * clock.nanoseconds() / static_cast<double>(bodies));
      }
      const ThreadClock clock;
      hits[who] = contestants[who]->cast(terrain.rays);
      if (round > 0) casts[who].push_back(1e-3 * clock.nanoseconds() / static_cast<double>(rays));
    }
  }
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    nlohmann::json& of = row[contestants[i]->name()];
    of["body_us"] = median(steps[i]);
    of["ray_us"] = median(casts[i]);
    std::printf(
        "%10.0f cells  %-7s build %9.2f ms  %6.2f bytes a cell  body %7.3f us  ray %7.3f us"
        "  touching %zu  hits %zu\n",
        cells, contestants[i]->name().c_str(), of["build_ms"].get<double>(),
        of["bytes_per_cell"].get<double>(), of["body_us"].get<double>(), of["ray_us"].get<double>(),
        touching[i], hits[i]);
  }
  return row;
}

}  // namespace

}  // namespace graze::benchmark

int main(int argc, char** argv) try {
  namespace bench = graze::benchmark;
  CLI::App app("Bodies and rays on height fields, beside Bullet where it is found");
  std::string output;
  std::vector<std::uint32_t> sides = {101, 1001};
  std::size_t bodies = 1000, rays = 10000;
  int rounds = 5;
  app.add_option("--output", output, "JSON file");
  app.add_option("--sides", sides, "heights along the sides of the terrains");
  app.add_option("--bodies", bodies, "on each terrain");
  app.add_option("--rays", rays, "at each terrain");
  app.add_option("--rounds", rounds, "repetitions")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);

  bench::Contestants contestants;
  contestants.push_back(bench::make_graze_field());
  contestants.push_back(bench::make_graze_mesh());
#ifdef GRAZE_HAS_BULLET
  contestants.push_back(bench::make_bullet());
#else
  std::puts("without Bullet, which was not found");
#endif
  nlohmann::json rows = nlohmann::json::array();
  for (const std::uint32_t side : sides)
    rows.push_back(bench::measure(contestants, side, bodies, rays, rounds));
  if (!output.empty()) {
    std::ofstream(output)
        << nlohmann::json{{"processor", bench::processor_name()}, {"rows", rows}}.dump(1) << '\n';
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
