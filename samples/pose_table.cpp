#include "samples/pose_table.h"

#include <graze/engine/mesh/pair.h>
#include <algorithm>
#include <cstdio>

#include "samples/median_time.h"
#include "samples/second_opinion.h"

namespace graze::samples {
namespace {

const char* word(bool is_hit) {
  return is_hit ? "hit" : "clear";
}

void print_head(const PoseTable& table, bool has_fcl) {
  std::printf("\n%s\n", table.title.c_str());
  std::printf("%4s %12s | %-6s %6s %10s %10s", "", "", "graze", "", "yes/no", "all pairs");
  std::printf("%s\n", has_fcl ? " | FCL           yes/no  all pairs" : "");
  std::printf("%4s %12s | %-6s %6s %10s %10s", "pose", table.column.c_str(), "", "pairs", "us",
              "us");
  std::printf("%s\n", has_fcl ? " |               us         us" : "");
}

void print_row(const Mesh& mesh_a, const Mesh& mesh_b, const Pose& pose,
               const SecondOpinion& second) {
  bool is_hit = false;
  std::size_t pairs = 0;
  const double hit_time = median_microseconds([&] {
    is_hit = intersects({mesh_a}, {mesh_b, pose});
  });
  const double pairs_time = median_microseconds([&] {
    pairs = find_triangle_pairs({mesh_a}, {mesh_b, pose}).size();
  });
  std::printf("%-6s %6zu %10.1f %10.1f", word(is_hit), pairs, hit_time, pairs_time);
  if (const auto opinion = second.on(pose)) {
    std::printf(" | %-6s %6zu %10.1f %10.1f", word(opinion->is_hit), opinion->pairs,
                opinion->hit_microseconds, opinion->pairs_microseconds);
  }
  std::printf("\n");
}

}  // namespace

std::vector<bool> answer_poses(const Mesh& mesh_a, const Mesh& mesh_b, std::span<const Pose> poses,
                               const PoseTable& table) {
  const SecondOpinion second(mesh_a, mesh_b);
  print_head(table, second.on(poses.front()).has_value());
  std::vector<bool> is_hit;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    is_hit.push_back(intersects({mesh_a}, {mesh_b, poses[i]}));
    if (i % table.rows_apart != 0) continue;
    std::printf("%4zu %12.3f | ", i, table.first + table.step * static_cast<double>(i));
    print_row(mesh_a, mesh_b, poses[i], second);
  }
  std::printf("%zu poses, %zu of them hits\n", poses.size(),
              static_cast<std::size_t>(std::ranges::count(is_hit, true)));
  return is_hit;
}

std::size_t first_hit(const std::vector<bool>& is_hit) {
  return static_cast<std::size_t>(std::ranges::find(is_hit, true) - is_hit.begin());
}

}  // namespace graze::samples
