// Milliseconds to find all self-intersections of a mesh whose tree is there, and whether there is
// any. Contestants take
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

/// Milliseconds of each turn.
struct Times {
  std::vector<double> graze, peer;

  double speed() const { return median(peer) / median(graze); }
};

/// Both take turns, once more than is kept: the first one builds the tree.
template <typename Graze, typename Peer>
Times in_turns(int rounds, Graze&& graze, Peer&& peer) {
  Times times;
  for (int round = 0; round <= rounds; ++round) {
    const ThreadClock clock;
    graze();
    const double time = clock.nanoseconds() / 1e6;
    const ThreadClock clock_of_peer;
    peer();
    const double time_of_peer = clock_of_peer.nanoseconds() / 1e6;
    if (round == 0) continue;
    times.graze.push_back(time);
    times.peer.push_back(time_of_peer);
  }
  return times;
}

nlohmann::json measure(const std::string& file, int rounds) {
  const Mesh mesh = load_mesh(file);
  const std::string name = std::filesystem::path(file).stem().string();
  const std::unique_ptr<SelfPeer> peer = make_peer(mesh);
  std::size_t pairs = 0, pairs_of_peer = 0;
  bool is_any = false, is_any_of_peer = false;
  const Times all = in_turns(
      rounds, [&] { pairs = find_self_pairs(mesh).size(); },
      [&] { pairs_of_peer = peer != nullptr ? peer->count_pairs() : 0; });
  const Times any = in_turns(
      rounds, [&] { is_any = self_intersects(mesh); },
      [&] { is_any_of_peer = peer != nullptr && peer->is_any(); });
  nlohmann::json row{{"mesh", name},
                     {"triangles", mesh.triangles().size()},
                     {"graze",
                      {{"milliseconds", median(all.graze)},
                       {"pairs", pairs},
                       {"any_milliseconds", median(any.graze)},
                       {"any", is_any}}}};
  std::printf("%-10s %8zu triangles  graze %8.2f ms, %zu pairs; any %8.3f ms", name.c_str(),
              mesh.triangles().size(), median(all.graze), pairs, median(any.graze));
  if (peer != nullptr) {
    row["cgal"] = {{"milliseconds", median(all.peer)},
                   {"pairs", pairs_of_peer},
                   {"any_milliseconds", median(any.peer)},
                   {"any", is_any_of_peer}};
    row["speed"] = all.speed();
    row["any_speed"] = any.speed();
    std::printf("  cgal %8.2f ms, %zu pairs; any %8.3f ms  speed %5.2f; any %5.2f",
                median(all.peer), pairs_of_peer, median(any.peer), all.speed(), any.speed());
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
