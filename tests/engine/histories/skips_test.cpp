// Each skip can be switched off: that changes what a world costs. That it changes no answer is what
// every history shows.

#include <graze/engine/work.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

using tests::at;

/// Twenty bodies at rest in a row, each touching the next, and a cone on its way past a drum.
WorldWork work_of(const WorldSettings& settings) {
  World world(settings);
  for (int i = 0; i < 20; ++i)
    world.add(Box{{0.5, 0.5, 0.5}}, at(i, 0, 0));
  world.add(Cylinder{1, 1}, at(0, 9, 0));
  const BodyId cone = world.add(Cone{0.5, 0.5}, at(1.3, 10.3, 0));
  WorldWork sum;
  for (int i = 0; i < 20; ++i) {
    world.move(cone, at(1.3, 10.3, 1e-3 * i));
    const WorldUpdate update = world.update();
    if (i == 0) continue;  // all came
    sum.shape_tests += update.work.shape_tests;
    sum.pairs_apart += update.work.pairs_apart;
    sum.pairs_at_rest += update.work.pairs_at_rest;
    EXPECT_TRUE(update.begun.empty() && update.ended.empty() && update.moved.empty());
  }
  EXPECT_EQ(world.pairs().size(), 19u);
  return sum;
}

TEST(Skips, OfPairsAtRestAndOfPairsApartSaveTests) {
  const WorldWork all = work_of({});
  EXPECT_EQ(all.pairs_at_rest, 19u * 19u);
  EXPECT_LT(all.shape_tests, 5u);
  const WorldWork without_rest = work_of({.skip_at_rest = false});
  EXPECT_EQ(without_rest.pairs_at_rest, 0u);
  EXPECT_EQ(without_rest.shape_tests, all.shape_tests + 19u * 19u);
  const WorldWork without_gaps = work_of({.skip_apart = false});
  EXPECT_EQ(without_gaps.pairs_apart, 0u);
  EXPECT_EQ(without_gaps.shape_tests, 19u);
  EXPECT_GT(all.pairs_apart, 14u);
}

/// Whether a question is the first to walk the mesh's trees.
bool has_no_tree(const Mesh& mesh) {
  Work work;
  mesh.tree(&work);
  const std::uint64_t built = work.trees_built;
  mesh.wide_tree(&work);
  EXPECT_EQ(work.trees_built, 2 * built);
  return built != 0;
}

TEST(Skips, OfTreesThatNobodyWalksSaveBuildingThem) {
  for (const bool skip : {true, false}) {
    World world({.skip_unused_trees = skip});
    const Mesh first = tests::make_sphere(1, 8, 12), second = tests::make_sphere(1, 8, 12);
    const BodyId id = world.add(first, at(0, 0, 0));
    world.add(Sphere{{0, 0, 0}, 1}, at(50, 0, 0));
    world.update();
    EXPECT_EQ(has_no_tree(first), skip);
    world.set_shape(id, second);
    world.update();
    EXPECT_EQ(has_no_tree(second), skip);
  }
}

}  // namespace
}  // namespace graze
