#include <graze/bvh/error.h>
#include <graze/bvh/wide/tree/wide_tree.h>
#include <graze/engine/mesh/data/mesh_data.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/mesh_cast.h>
#include <graze/engine/mesh/mesh_ray.h>
#include <graze/engine/mesh/pose_batch.h>
#include <graze/engine/mesh/prepare.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

std::vector<Pose> poses_of(std::size_t count, double reach) {
  RandomSource source(7);
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < count; ++i)
    poses.push_back(tests::random_pose(reach, source));
  return poses;
}

std::vector<std::vector<TrianglePair>> pairs_of(const std::vector<TrianglePairs>& all) {
  std::vector<std::vector<TrianglePair>> pairs;
  for (const TrianglePairs& found : all)
    pairs.push_back(found.pairs);
  return pairs;
}

TEST(Prepare, BuildsAllAtOnceAndChangesNoAnswer) {
  const Mesh lazy = tests::make_sphere(1, 80, 80);
  const Mesh eager = tests::make_sphere(1, 80, 80);
  Work work;
  prepare(eager, {}, &work);
  EXPECT_EQ(work.trees_built, 1u);
  EXPECT_EQ(work.treelets_built + 1, wide_tree_of(eager).treelet_count());
  EXPECT_GT(work.treelets_built, 4u);
  Work again;
  prepare(eager, {}, &again);
  Work asked;
  for (const Pose& pose : poses_of(20, 1)) {
    EXPECT_EQ(find_triangle_pairs({eager}, {eager, pose}, {}, &asked).pairs,
              find_triangle_pairs({lazy}, {lazy, pose}).pairs);
  }
  EXPECT_EQ(again.trees_built + again.treelets_built, 0u);
  EXPECT_EQ(asked.trees_built + asked.treelets_built, 0u);
}

TEST(Prepare, ForAllQueriesLeavesNothingToBuild) {
  const Mesh mesh = tests::make_sphere(1, 40, 40);
  prepare(mesh, {.queries = PreparedFor::All});
  EXPECT_TRUE(MeshAccess::data(mesh).are_rays_made);
  Pose pose = Pose::Identity();
  pose.translation().x() = 3;
  Work asked;
  EXPECT_TRUE(intersects(mesh, Ray{{3, 0, 0}, {-1, 0, 0}}, &asked));
  EXPECT_TRUE(cast({mesh}, {mesh, pose}, {-2, 0, 0}, {}, &asked));
  EXPECT_FALSE(intersects({mesh}, {mesh, pose}, {}, &asked));
  EXPECT_EQ(asked.trees_built + asked.treelets_built + asked.skins_built, 0u);
}

TEST(Prepare, FromManyThreadsBesideQueriesBuildsOnce) {
  const Mesh mesh = tests::make_sphere(1, 80, 80);
  Pose pose = Pose::Identity();
  pose.translation().x() = 0.5;
  std::vector<Work> works(6);
  std::vector<TrianglePairs> found(works.size());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < works.size(); ++i) {
    threads.emplace_back([&, i] {
      if (i % 2 == 0) prepare(mesh, {}, &works[i]);
      found[i] = find_triangle_pairs({mesh}, {mesh, pose}, {}, &works[i]);
    });
  }
  Work sum;
  for (std::size_t i = 0; i < works.size(); ++i) {
    threads[i].join();
    sum += works[i];
    EXPECT_EQ(found[i].pairs, found[0].pairs);
  }
  EXPECT_EQ(sum.trees_built, 1u);
  EXPECT_EQ(sum.treelets_built + 1, wide_tree_of(mesh).treelet_count());
}

TEST(Law8, BatchesAnswerAsSingleQueriesForAnyNumberOfThreads) {
  const Mesh a = tests::make_torus(1, 0.3, 40, 20);
  const Mesh b = tests::make_sphere(0.5, 20, 20);
  const std::vector<Pose> poses = poses_of(300, 1.2);
  std::vector<bool> hits;
  std::vector<std::vector<TrianglePair>> pairs;
  for (const Pose& pose : poses) {
    hits.push_back(intersects({a}, {b, pose}));
    pairs.push_back(find_triangle_pairs({a}, {b, pose}).pairs);
  }
  for (const int threads : {0, 1, 2, 5}) {
    Work work;
    EXPECT_EQ(intersects({a}, {b, poses}, {}, {.threads = threads}, &work), hits);
    EXPECT_GE(work.volume_tests, poses.size());
    EXPECT_EQ(pairs_of(find_triangle_pairs({a}, {b, poses}, {}, {.threads = threads})), pairs);
  }
  const std::span<const Pose> few(poses.data(), 5);
  const std::vector<MeshDistance> gaps = distance({a}, {b, few}, {}, {.threads = 2});
  for (std::size_t i = 0; i < few.size(); ++i) {
    const MeshDistance gap = distance({a}, {b, few[i]});
    EXPECT_EQ(gaps[i].distance, gap.distance);
    EXPECT_EQ(gaps[i].pair, gap.pair);
  }
  EXPECT_TRUE(intersects({a}, {b, std::span<const Pose>{}}).empty());
}

TEST(Law8, OneQuerySharedByThreadsFindsTheSamePairs) {
  RandomSource source(8);
  const Mesh soup_a = tests::random_soup({.count = 3000, .size = 0.25}, source);
  const Mesh soup_b = tests::random_soup({.count = 3000, .size = 0.25}, source);
  const Mesh sphere = tests::make_sphere(1, 60, 60);
  std::size_t most = 0;
  for (const Pose& pose : poses_of(12, 0.4)) {
    for (const auto& [a, b] : {std::pair(soup_a, soup_b), std::pair(sphere, sphere)}) {
      Work alone;
      const TrianglePairs serial = find_triangle_pairs({a}, {b, pose}, {}, &alone);
      most = std::max(most, serial.size());
      for (const int threads : {0, 2, 3, 8}) {
        Work shared;
        EXPECT_EQ(find_triangle_pairs({a}, {b, pose}, {.threads = threads}, &shared).pairs,
                  serial.pairs);
        EXPECT_EQ(shared.volume_tests, alone.volume_tests);
        EXPECT_EQ(shared.triangle_tests, alone.triangle_tests);
      }
    }
  }
  EXPECT_GT(most, 3000u);  // more than one thread begins with alone
  const Mesh single = tests::make_row(1);
  EXPECT_EQ(find_triangle_pairs({single}, {single}, {.threads = 2}).size(), 1u);
}

TEST(PoseBatch, ErrorsNameThePose) {
  const Mesh mesh = tests::make_row(1);
  std::vector<Pose> poses(4, Pose::Identity());
  EXPECT_THROW(intersects({mesh}, {mesh, poses}, {}, {.threads = -1}), InputError);
  EXPECT_THROW(find_triangle_pairs({mesh}, {mesh}, {.threads = -1}), InputError);
  poses[2].linear() *= 2;
  try {
    intersects({mesh}, {mesh, poses});
    FAIL() << "a pose that is not rigid was accepted";
  } catch (const PoseError& error) {
    EXPECT_NE(std::string(error.what()).find("pose 2 of mesh B"), std::string::npos);
  }
}

}  // namespace
}  // namespace graze
