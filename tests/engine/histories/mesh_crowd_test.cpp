// Worlds of bundled meshes against the exact answer for each pair.

#include <gtest/gtest.h>

#include "tests/engine/histories/mesh_crowd.h"

namespace graze::tests {
namespace {

void expect_exact(const CrowdSettings& settings, int steps) {
  MeshCrowd crowd(settings);
  for (int step = 0; step < steps; ++step) {
    crowd.step();
    ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << settings.seed << ", step " << step;
  }
  const auto bodies = static_cast<std::size_t>(settings.bodies);
  EXPECT_GT(crowd.touching(), bodies / 4);
  EXPECT_GT(crowd.begun(), bodies / 2);
  EXPECT_GT(crowd.skipped(), bodies / 2);
}

TEST(MeshCrowd, TouchesAsEachPairDoes) {
  expect_exact({.bodies = 80, .seed = 1}, 100);
  expect_exact({.bodies = 80, .seed = 2, .world = {.contacts = false}}, 100);
}

TEST(MeshCrowdSlow, OfTwoThousandTouchesAsEachPairDoes) {
  expect_exact({.bodies = 2000, .seed = 3, .world = {.threads = 2}}, 25);
  expect_exact({.bodies = 2000, .seed = 4, .world = {.contacts = false}}, 25);
}

TEST(MeshCrowdSlow, OfAnySeedTouchesAsEachPairDoes) {
  for (std::uint64_t seed = 10; seed < 30; ++seed)
    expect_exact({.bodies = 300, .seed = seed, .world = {.contacts = seed % 2 == 0}}, 60);
}

}  // namespace
}  // namespace graze::tests
