// Milliseconds to find all self-intersections of a mesh whose tree is there. Contestants take
// turns, and medians are compared. Prints a table and writes JSON.

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/self.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/benchmark/common/median.h"
#include "tests/benchmark/common/processor_name.h"
#include "tests/benchmark/common/thread_clock.h"
#include "tests/benchmark/self/peer.h"

namespace graze::benchmark {
namespace {

/// Null where there is none.
std::unique_ptr<SelfPeer> make_peer([[maybe_unused]] const Mesh& mesh) {
#ifdef GRAZE_HAS_CGAL
  return make_cgal_self(mesh);
#else
  return nullptr;
#endif
}

nlohmann::json measure(const std::string& file, int rounds) {
  const Mesh mesh = load_mesh(file);
  const std::string name = std::filesystem::path(file).stem().string();
  const std::unique_ptr<SelfPeer> peer = make_peer(mesh);
  std::vector<double> times, times_of_peer;
  std::size_t pairs = 0, pairs_of_peer = 0;
  for (int round = 0; round <= rounds; ++round) {
    const ThreadClock clock;
    pairs = find_self_pairs(mesh).size();
    const double time = clock.nanoseconds() / 1e6;
    const ThreadClock clock_of_peer;
    if (peer != nullptr) pairs_of_peer = peer->count_pairs();
    const double time_of_peer = clock_of_peer.nanoseconds() / 1e6;
    if (round == 0) continue;  // which builds the tree
    times.push_back(time);
    times_of_peer.push_back(time_of_peer);
  }
  nlohmann::json row{{"mesh", name},
                     {"triangles", mesh.triangles().size()},
                     {"graze", {{"milliseconds", median(times)}, {"pairs", pairs}}}};
  std::printf("%-10s %8zu triangles  graze %8.2f ms, %zu pairs", name.c_str(),
              mesh.triangles().size(), median(times), pairs);
  if (peer != nullptr) {
    row["cgal"] = {{"milliseconds", median(times_of_peer)}, {"pairs", pairs_of_peer}};
    row["speed"] = median(times_of_peer) / median(times);
    std::printf("  cgal %8.2f ms, %zu pairs  speed %5.2f", median(times_of_peer), pairs_of_peer,
                row["speed"].get<double>());
  }
  std::puts("");
  return row;
}

}  // namespace
}  // namespace graze::benchmark

int main(int argc, char** argv) try {
  namespace bench = graze::benchmark;
  CLI::App app("Milliseconds to find self-intersections, beside CGAL where it is found");
  std::string data = "data", output;
  std::vector<std::string> files;
  int rounds = 7;
  app.add_option("--output", output, "JSON file");
  app.add_option("--data", data, "the project's data");
  app.add_option("--mesh", files, "more meshes");
  app.add_option("--rounds", rounds, "repetitions")->check(CLI::Range(1, 1000));
  CLI11_PARSE(app, argc, argv);

  nlohmann::json rows = nlohmann::json::array();
  for (const char* bundled : {"bolt.obj", "gear.ply", "rock.ply", "terrain.ply"})
    files.push_back(data + "/meshes/" + bundled);
  for (const std::string& file : files)
    rows.push_back(bench::measure(file, rounds));
  if (!output.empty()) {
    std::ofstream(output)
        << nlohmann::json{{"processor", bench::processor_name()}, {"rows", rows}}.dump(1) << '\n';
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
