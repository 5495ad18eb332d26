// Each skip can be switched off: that changes what a world costs. That it changes no answer is what
// every history shows.

#include <graze/engine/mesh/data/mesh_trees.h>
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
    world.add({Box{{0.5, 0.5, 0.5}}, at(i, 0, 0)});
  world.add({Cylinder{1, 1}, at(0, 9, 0)});
  const BodyId cone = world.add({Cone{0.5, 0.5}, at(1.3, 10.3, 0)});
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
  tree_of(mesh, &work);
  const std::uint64_t built = work.trees_built;
  wide_tree_of(mesh, &work);
  EXPECT_EQ(work.trees_built, 2 * built);
  return built != 0;
}

TEST(Skips, OfTreesThatNobodyWalksSaveBuildingThem) {
  for (const bool skip : {true, false}) {
    World world({.skip_unused_trees = skip});
    const Mesh first = tests::make_sphere(1, 8, 12), second = tests::make_sphere(1, 8, 12);
    const BodyId id = world.add({first, at(0, 0, 0)});
    world.add({Sphere{{0, 0, 0}, 1}, at(50, 0, 0)});
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
  world.add({near, at(0, 0, 0)}, {.kind = BodyKind::Static});
  world.add({far, at(90, 0, 0)}, {.kind = BodyKind::Static});
  const BodyId ball = world.add({Sphere{{0, 0, 0}, 1}, at(50, 0, 0)});
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

std::vector<BodyId> add_apart(World& world, const std::vector<Mesh>& meshes) {
  std::vector<BodyId> ids;
  for (const Mesh& mesh : meshes)
    ids.push_back(world.add({mesh, at(4.0 * static_cast<double>(ids.size()), 0, 0)}));
  return ids;
}

std::vector<Mesh> make_spheres(int count) {
  std::vector<Mesh> meshes;
  for (int i = 0; i < count; ++i)
    meshes.push_back(tests::make_sphere(1, 8, 12));
  return meshes;
}

TEST(UnbuiltTrees, OfMeshesApartAreAllAndThoseThatMeetAreBuilt) {
  World world;
  const std::vector<Mesh> meshes = make_spheres(10);
  const std::vector<BodyId> ids = add_apart(world, meshes);
  const WorldWork first = world.update().work;
  EXPECT_EQ(first.trees_unbuilt, 10u);
  EXPECT_EQ(first.shapes.trees_built, 0u);
  world.move(ids[3], at(4.5, 0, 0));  // over the one with number 1
  const WorldWork met = world.update().work;
  EXPECT_EQ(met.shapes.trees_built, 2u);
  EXPECT_EQ(met.trees_unbuilt, 8u);
  EXPECT_EQ(world.update().work.trees_unbuilt, 8u);
  for (std::size_t i = 0; i < meshes.size(); ++i)
    EXPECT_EQ(has_tree(meshes[i]), i == 1 || i == 3) << i;
  // A new look at a pair whose boxes part again builds nothing.
  world.move(ids[3], at(12, 0, 0));
  EXPECT_EQ(world.update().work.trees_unbuilt, 8u);
}

TEST(UnbuiltTrees, AreNoneWhereTheSkipIsOff) {
  World world({.skip_unused_trees = false});
  const std::vector<Mesh> meshes = make_spheres(4);
  add_apart(world, meshes);
  world.add({Sphere{{0, 0, 0}, 1}, at(0, 9, 0)});
  EXPECT_EQ(world.update().work.trees_unbuilt, 0u);
}

TEST(UnbuiltTrees, OfMeshesThatBodiesShareAreCountedOnce) {
  World world;
  const Mesh shared = tests::make_sphere(1, 8, 12);
  const std::vector<BodyId> ids = add_apart(world, {shared, shared, shared});
  EXPECT_EQ(world.update().work.trees_unbuilt, 1u);
  world.remove(ids[0]);
  EXPECT_EQ(world.update().work.trees_unbuilt, 1u);
  const WorldSnapshot snapshot = world.snapshot();
  world.remove(ids[1]), world.remove(ids[2]);
  EXPECT_EQ(world.update().work.trees_unbuilt, 0u);
  world.restore(snapshot);
  EXPECT_EQ(world.update().work.trees_unbuilt, 1u);
  world.add({Sphere{{0, 0, 0}, 1}, at(4, 0, 0)});
  EXPECT_EQ(world.update().work.trees_unbuilt, 0u);
  // The mark of the other body that shares it is void, and takes no other mesh's entry with it.
  world.add({tests::make_sphere(1, 8, 12), at(0, 9, 0)});
  world.remove(ids[2]), world.remove(ids[1]);
  EXPECT_EQ(world.update().work.trees_unbuilt, 1u);
}

TEST(UnbuiltTrees, FollowTheShapesThatBodiesTake) {
  World world;
  const BodyId id = world.add({Sphere{{0, 0, 0}, 1}, at(0, 0, 0)});
  EXPECT_EQ(world.update().work.trees_unbuilt, 0u);
  for (int i = 0; i < 3; ++i) {
    world.set_shape(id, tests::make_sphere(1, 8, 12));
    EXPECT_EQ(world.update().work.trees_unbuilt, 1u);
  }
  world.set_shape(id, Sphere{{0, 0, 0}, 1});
  EXPECT_EQ(world.update().work.trees_unbuilt, 0u);
}

TEST(UnbuiltTrees, ThatAreBuiltElsewhereAreSeenWhereAnUpdateLooks) {
  World world;
  const Mesh mesh = tests::make_sphere(1, 8, 12);
  const BodyId id = world.add({mesh, at(0, 0, 0)});
  EXPECT_EQ(world.update().work.trees_unbuilt, 1u);
  EXPECT_EQ(world.find_touching({Sphere{{0, 0, 0}, 1}, at(1, 0, 0)}).size(), 1u);
  EXPECT_TRUE(has_tree(mesh));
  EXPECT_EQ(world.update().work.trees_unbuilt, 1u);
  world.move(id, at(0, 0, 0));
  EXPECT_EQ(world.update().work.trees_unbuilt, 0u);
  // Only the tree that other volumes walk: it counts as well.
  const Mesh other = tests::make_sphere(1, 8, 12);
  tree_of(other);
  world.add({other, at(9, 0, 0)});
  EXPECT_EQ(world.update().work.trees_unbuilt, 0u);
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
    poses.back().rotate(Eigen::AngleAxisd(1e-3, Eigen::Vector3d::UnitX()));
  }
  for (std::size_t i = 0; i < shapes.size(); ++i)
    world.add({shapes[i], poses[i]});
  const Work found = world.update().work.shapes;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t j = i + 1; j < shapes.size(); ++j)
      find_contacts({shapes[i], poses[i]}, {shapes[j], poses[j]}, &all);
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
  const BodyId a = world.add({Box{{1, 1, 1}}, at(0, 0, 0)}, {.filter = {.category = 2}});
  const BodyId b = world.add({Box{{1, 1, 1}}, at(1, 0, 0)}, {.filter = {.mask = 1}});
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
  world.add({Box{{1, 1, 1}}, at(0, 1, 0)}, {.kind = BodyKind::Static});
  EXPECT_EQ(world.update().work.pairs_filtered, 3u);
  EXPECT_EQ(asked, 3);
}

}  // namespace
}  // namespace graze
