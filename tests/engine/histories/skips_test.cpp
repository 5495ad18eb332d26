// Each skip can be switched off: that changes what a world costs. That it changes no answer is what
// every history shows.

#include <graze/engine/work.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

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

TEST(Skips, OfTreesAreCountedWhereTheyEnd) {
  World world;
  const Mesh near = tests::make_sphere(1, 8, 12), far = tests::make_sphere(1, 8, 12);
  world.add(near, at(0, 0, 0), {.motion = Motion::Static});
  world.add(far, at(90, 0, 0), {.motion = Motion::Static});
  const BodyId ball = world.add(Sphere{{0, 0, 0}, 1}, at(50, 0, 0));
  EXPECT_EQ(world.update().work.shapes.trees_built, 0u);
  world.move(ball, at(1.5, 0, 0));
  const WorldUpdate met = world.update();
  EXPECT_EQ(met.begun.size(), 1u);
  EXPECT_EQ(met.work.shapes.trees_built, 1u);
  EXPECT_GT(met.work.shapes.triangle_tests, 0u);
  world.move(ball, at(1.4, 0, 0));
  EXPECT_EQ(world.update().work.shapes.trees_built, 0u);
  EXPECT_TRUE(has_no_tree(far));
}

/// Cones that are flat by a millionth are found out about by searches that come to no proof.
TEST(Skips, SearchesAreCountedAsThoseOfThePairsAre) {
  World world;
  Work all;
  std::vector<Shape> shapes;
  std::vector<Pose> poses;
  for (int i = 0; i < 24; ++i) {
    shapes.emplace_back(Cone{1, std::ldexp(1.0, -i)});
    shapes.emplace_back(Cylinder{1, std::ldexp(1.0, -i)});
    poses.push_back(at(0.01 * i, 0.02 * i, 0.5)), poses.push_back(at(0.02 * i, 0.01 * i, 0.4));
  }
  for (std::size_t i = 0; i < shapes.size(); ++i)
    world.add(shapes[i], poses[i]);
  const Work found = world.update().work.shapes;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t j = i + 1; j < shapes.size(); ++j)
      find_contacts(shapes[i], poses[i], shapes[j], poses[j], &all);
  }
  EXPECT_GT(found.convex_tests, 100u);
  EXPECT_EQ(found.penetration_tests, all.penetration_tests);
  EXPECT_EQ(found.penetration_failures, all.penetration_failures);
  EXPECT_EQ(found.convex_failures, all.convex_failures);
  EXPECT_GT(found.penetration_failures + found.convex_failures, 0u);
  EXPECT_EQ(world.update().work.shapes.convex_tests, 0u);
}

/// Once where boxes begin to overlap, and once where a filter changes.
TEST(Skips, OfFilteredPairsAreCountedOnce) {
  World world;
  int asked = 0;
  const BodyId a = world.add(Box{{1, 1, 1}}, at(0, 0, 0), {.filter = {.category = 2}});
  const BodyId b = world.add(Box{{1, 1, 1}}, at(1, 0, 0), {.filter = {.mask = 1}});
  EXPECT_EQ(world.update().work.pairs_filtered, 1u);
  EXPECT_EQ(world.update().work.pairs_filtered, 0u);
  world.move(a, at(0.1, 0, 0));
  EXPECT_EQ(world.update().work.pairs_filtered, 0u);
  world.set_filter(b, {.mask = 5});
  EXPECT_EQ(world.update().work.pairs_filtered, 1u);
  world.set_filter(a, {}), world.set_filter(b, {});
  WorldUpdate update = world.update();
  EXPECT_EQ(update.work.pairs_filtered, 0u);
  EXPECT_EQ(update.begun.size(), 1u);
  world.exclude(a, b);
  update = world.update();
  EXPECT_EQ(update.work.pairs_filtered, 1u);
  EXPECT_EQ(update.ended.size(), 1u);
  world.include(a, b);
  world.set_pair_filter([&](BodyId, BodyId) { return ++asked, false; });
  world.add(Box{{1, 1, 1}}, at(0, 1, 0), {.motion = Motion::Static});
  EXPECT_EQ(world.update().work.pairs_filtered, 3u);
  EXPECT_EQ(asked, 3);
}

}  // namespace
}  // namespace graze
