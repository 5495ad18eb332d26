// Microseconds to know whether a body of many parts, or of voxels, touches something in a pose:
// compounds beside Bullet's and FCL's objects in a manager, maps of voxels beside FCL's octree.
// Contestants take turns; medians. Answers are compared pose by pose. Prints a table and writes
// JSON.

#include <malloc.h>

#include <graze/bvh/error.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/voxel_map.h>
#include <graze/engine/world/world.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/benchmark/common/median.h"
#include "tests/benchmark/common/processor_name.h"
#include "tests/benchmark/common/thread_clock.h"
#include "tests/benchmark/compounds/contestant.h"

namespace graze::benchmark {

namespace {

/// What is apart, or reaches into each other, by less than this is near enough for either answer,
/// metres: the others' searches end so near.
constexpr double kNear = 1e-5;

/// What the C library has handed out.
double bytes_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

/// Whether the answer about the parts in that pose is clear, part by part.
bool is_clear(const Parts& parts, const Asked& asked, const Pose& pose) {
  double gap = 1e300, depth = 0;
  for (const PlacedShape& own : asked.parts) {
    const PlacedShape at{own.shape, placed_part(pose, own.pose)};
    for (const PlacedShape& part : parts) {
      gap = std::min(gap, distance(part, at).distance);
      for (const ShapeContact& contact : find_contacts(part, at))
        depth = std::max(depth, contact.depth);
    }
  }
  return gap > kNear || depth > kNear;
}

Parts boxes_of(const Voxels& voxels) {
  const VoxelMap map(voxels);
  Parts boxes;
  for (const Voxel& voxel : map.voxels())
    boxes.push_back({map.box(), map.pose(map.part(voxel))});
  return boxes;
}

struct Settings {
  int rounds = 5;
  int wrong = 0;  ///< clear poses that somebody answered otherwise
};

/// Of one body and what is asked: a row of the table for each contestant.
template <typename PartsOf>
nlohmann::json measure(const std::string& scene, std::size_t count, Contestants& contestants,
                       const Asked& asked, const PartsOf& parts_of, Settings& settings) {
  nlohmann::json row{{"scene", scene}, {"elements", count}, {"poses", asked.poses.size()}};
  std::vector<std::vector<double>> times(contestants.size());
  std::vector<std::vector<bool>> answers(contestants.size());
  for (auto& contestant : contestants) {
    std::vector<double> builds;
    double bytes = 0;
    for (int i = 0; i < settings.rounds; ++i) {
      const double before = bytes_in_use();
      const ThreadClock clock;
      contestant->build();
      builds.push_back(clock.nanoseconds());
      if (i == 0) bytes = bytes_in_use() - before;
    }
    contestant->take(asked);
    row[contestant->name()] = {{"build_ms", median(builds) * 1e-6},
                               {"bytes", bytes / static_cast<double>(count)}};
  }
  for (int round = 0; round <= settings.rounds; ++round) {
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      const std::size_t who = (i + static_cast<std::size_t>(round)) % contestants.size();
      std::vector<bool> says;
      says.reserve(asked.poses.size());
      const ThreadClock clock;
      for (const Pose& pose : asked.poses)
        says.push_back(contestants[who]->touches(pose));
      const double each = 1e-3 * clock.nanoseconds() / static_cast<double>(asked.poses.size());
      if (round > 0) times[who].push_back(each);
      answers[who] = std::move(says);
    }
  }
  for (std::size_t who = 0; who < contestants.size(); ++who) {
    int others = 0, wrong = 0;
    for (std::size_t i = 0; i < asked.poses.size(); ++i) {
      if (answers[who][i] == answers[0][i]) continue;
      ++others;
      wrong += is_clear(parts_of(), asked, asked.poses[i]);
    }
    settings.wrong += wrong;
    const auto hits = std::count(answers[who].begin(), answers[who].end(), true);
    nlohmann::json& of = row[contestants[who]->name()];
    of["ask_us"] = median(times[who]);
    of["hits"] = hits;
    of["other_answers"] = others;
    of["other_answers_where_clear"] = wrong;
    std::printf(
        "%-22s %8zu  %-10s build %9.2f ms  %7.2f bytes each  ask %8.3f us  hits %td"
        "  other answers %d, where clear %d\n",
        scene.c_str(), count, contestants[who]->name().c_str(), of["build_ms"].get<double>(),
        of["bytes"].get<double>(), of["ask_us"].get<double>(), hits, others, wrong);
  }
  std::fflush(stdout);
  return row;
}

nlohmann::json measure_parts(std::size_t count, std::size_t asked_parts, std::size_t poses,
                             Settings& settings) {
  const double side = 0.3 * std::cbrt(static_cast<double>(count));
  const Parts parts = random_parts(count, side);
  const Asked asked = random_asked(asked_parts, poses, side);
  Contestants contestants;
  add_graze(parts, contestants);
#ifdef GRAZE_HAS_BULLET
  add_bullet(parts, contestants);
#endif
#ifdef GRAZE_HAS_FCL
  add_fcl(parts, contestants);
#endif
  const std::string scene = "parts, asked of " + std::to_string(asked_parts);
  return measure(
      scene, count, contestants, asked, [&] { return parts; }, settings);
}

/// Microseconds to find the nearest voxel, of which nobody else tells, from ten times as far away.
double microseconds_to_nearest(const Voxels& voxels, const Asked& asked) {
  constexpr std::size_t kMost = 200;
  World world;
  world.add({share(VoxelMap(voxels)), Pose::Identity()});
  std::vector<double> times;
  for (std::size_t i = 0; i < std::min(kMost, asked.poses.size()); ++i) {
    Pose pose = asked.poses[i];
    pose.translation() *= 10;
    const ThreadClock clock;
    if (!world.find_closest({asked.parts[0].shape, pose})) throw Error("no voxel is the nearest");
    times.push_back(1e-3 * clock.nanoseconds());
  }
  return median(times);
}

nlohmann::json measure_voxels(std::uint32_t side, bool is_solid, std::size_t poses,
                              Settings& settings) {
  const Voxels voxels = ball_of_voxels(side, is_solid);
  const Asked asked = random_asked(1, poses, voxels.grid.edge * side);
  Contestants contestants;
  add_graze(voxels, contestants);
#ifdef GRAZE_HAS_OCTOMAP
  add_fcl_octree(voxels, contestants);
#endif
  const char* scene = is_solid ? "voxels of a ball" : "voxels of its surface";
  const auto boxes = [&] { return boxes_of(voxels); };
  nlohmann::json row = measure(scene, voxels.voxels.size(), contestants, asked, boxes, settings);
  const double nearest = microseconds_to_nearest(voxels, asked);
  row["graze"]["nearest_us"] = nearest;
  std::printf("%-22s %8zu  graze      nearest voxel from afar %8.1f us\n", scene,
              voxels.voxels.size(), nearest);
  return row;
}

}  // namespace

}  // namespace graze::benchmark

int main(int argc, char** argv) try {
  namespace bench = graze::benchmark;
  CLI::App app("Bodies of many parts and of voxels, beside Bullet and FCL where they are found");
  std::string output;
  std::vector<std::size_t> counts = {100, 1000, 10000};
  std::vector<std::uint32_t> sides = {64, 160};
  std::size_t poses = 2000;
  bench::Settings settings;
  app.add_option("--output", output, "JSON file");
  app.add_option("--parts", counts, "of the compounds");
  app.add_option("--sides", sides, "voxels along the sides of the grids");
  app.add_option("--poses", poses, "in which each is asked about");
  app.add_option("--rounds", settings.rounds, "repetitions")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);

#ifndef GRAZE_HAS_BULLET
  std::puts("without Bullet, which was not found");
#endif
#ifndef GRAZE_HAS_FCL
  std::puts("without FCL, which was not found");
#endif
#ifndef GRAZE_HAS_OCTOMAP
  std::puts("without FCL's octrees: FCL or octomap was not found");
#endif
  nlohmann::json rows = nlohmann::json::array();
  for (const std::size_t count : counts) {
    for (const std::size_t asked : {std::size_t{1}, std::size_t{32}})
      rows.push_back(bench::measure_parts(count, asked, poses, settings));
  }
  for (const std::uint32_t side : sides) {
    for (const bool is_solid : {false, true})
      rows.push_back(bench::measure_voxels(side, is_solid, poses, settings));
  }
  if (!output.empty()) {
    std::ofstream(output)
        << nlohmann::json{{"processor", bench::processor_name()}, {"rows", rows}}.dump(1) << '\n';
  }
  if (settings.wrong == 0) return 0;
  std::fprintf(stderr, "%d answers differ where no rounding explains it\n", settings.wrong);
  return 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
