// Two spur gears: at their nominal distance they roll freely, pushed together their teeth bind.
// gears_in_mesh DATA_DIR

#include <graze/graze.h>
#include <algorithm>
#include <cstdio>

#include "samples/pose_table.h"

namespace {

// Known from how the poses are made (data/README.md): the backlash of 0.08 mm is used up when the
// centres are 0.110 mm too close, between the poses 10 and 11.
constexpr std::size_t kFirstBinding = 11;
constexpr double kRollStep = 360.0 / 31 / 60;

int run(const std::filesystem::path& data) {
  const graze::Mesh gear = graze::load_mesh(data / "meshes/gear.ply");
  const graze::Mesh pinion = graze::load_mesh(data / "meshes/pinion.off");
  const auto rolling = graze::load_poses(data / "poses/gear-pinion.mesh.txt");
  const auto tight = graze::load_poses(data / "poses/gear-pinion.tight.txt");

  const auto is_rolling_hit = graze::samples::answer_poses(
      gear, pinion, rolling,
      {"Rolling over one pitch of the teeth", "turned, deg", 0, kRollStep, 5});
  const auto is_tight_hit = graze::samples::answer_poses(
      gear, pinion, tight, {"Pushed together", "distance, mm", 50.1, -0.02, 1});

  const bool is_right = graze::samples::first_hit(is_rolling_hit) == rolling.size() &&
                        graze::samples::first_hit(is_tight_hit) == kFirstBinding &&
                        std::all_of(is_tight_hit.begin() + kFirstBinding, is_tight_hit.end(),
                                    [](bool is_hit) { return is_hit; });
  std::printf("\n%s: at 50 mm the gears roll freely, from 49.88 mm on they bind\n",
              is_right ? "as it must be" : "WRONG, it must be");
  return is_right ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: gears_in_mesh DATA_DIR\n");
    return 2;
  }
  try {
    return run(argv[1]);
  } catch (const graze::Error& error) {
    std::fprintf(stderr, "gears_in_mesh: %s\n", error.what());
    return 1;
  }
}
