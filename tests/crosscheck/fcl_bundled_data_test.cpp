// graze and FCL on every bundled pose of the bundled meshes.

#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/pose_text.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>

#include "tests/crosscheck/cross_check.h"

namespace graze {
namespace {

const std::filesystem::path kData = GRAZE_DATA_DIR;

const std::map<std::string, std::string> kMeshFiles = {
    {"bolt", "bolt.obj"}, {"nut", "nut.stl"},   {"gear", "gear.ply"},      {"pinion", "pinion.off"},
    {"link", "link.ply"}, {"rock", "rock.ply"}, {"terrain", "terrain.ply"}};

Mesh load_bundled(const std::string& name) {
  return load_mesh(kData / "meshes" / kMeshFiles.at(name));
}

/// All files `a-b.*.txt` of poses.
tests::CrossCheckCounts check_bundled(const std::string& name_a, const std::string& name_b) {
  const Mesh mesh_a = load_bundled(name_a);
  const Mesh mesh_b = load_bundled(name_b);
  tests::CrossCheckCounts all;
  for (const auto& entry : std::filesystem::directory_iterator(kData / "poses")) {
    const std::string file = entry.path().filename().string();
    if (!file.starts_with(name_a + "-" + name_b + ".")) continue;
    SCOPED_TRACE(file);
    const tests::CrossCheckCounts counts =
        tests::cross_check(mesh_a, mesh_b, load_poses(entry.path()));
    all.intersecting += counts.intersecting;
    all.apart += counts.apart;
    all.pairs += counts.pairs;
    all.differences += counts.differences;
  }
  return all;
}

TEST(FclBundledData, BoltAndNut) {
  const tests::CrossCheckCounts counts = check_bundled("bolt", "nut");
  EXPECT_GT(counts.intersecting, 5u);
  EXPECT_GT(counts.apart, 5u);
  EXPECT_GT(counts.pairs, 100u);
}

TEST(FclBundledData, GearAndPinion) {
  const tests::CrossCheckCounts counts = check_bundled("gear", "pinion");
  EXPECT_GT(counts.intersecting, 5u);
  EXPECT_GT(counts.apart, 5u);
  EXPECT_GT(counts.pairs, 100u);
}

TEST(FclBundledData, LinkAndLink) {
  const tests::CrossCheckCounts counts = check_bundled("link", "link");
  EXPECT_EQ(counts.intersecting, 72u);
  EXPECT_EQ(counts.apart, 108u);
  EXPECT_GT(counts.pairs, 1000u);
}

TEST(FclBundledData, RockAndRock) {
  const tests::CrossCheckCounts counts = check_bundled("rock", "rock");
  EXPECT_EQ(counts.intersecting, 72u);
  EXPECT_EQ(counts.apart, 72u);
  EXPECT_GT(counts.pairs, 1000u);
}

TEST(FclBundledData, TerrainAndRock) {
  const tests::CrossCheckCounts counts = check_bundled("terrain", "rock");
  EXPECT_EQ(counts.intersecting, 72u);
  EXPECT_EQ(counts.apart, 72u);
  EXPECT_GT(counts.pairs, 1000u);
}

TEST(FclBundledData, NoFileOfPosesIsLeftOut) {
  for (const auto& entry : std::filesystem::directory_iterator(kData / "poses")) {
    const std::string pair = entry.path().stem().stem().string();
    EXPECT_TRUE(pair == "bolt-nut" || pair == "gear-pinion" || pair == "link-link" ||
                pair == "rock-rock" || pair == "terrain-rock")
        << entry.path();
  }
}

}  // namespace
}  // namespace graze
