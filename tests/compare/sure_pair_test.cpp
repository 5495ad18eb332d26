// What the judge takes for sure without integers: against the linear program in integers, over
// every kind of hard input; and its walk over boxes that a pose turns, against all pairs.

#include <graze/engine/compare/judge/rational/mesh_referee.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>
#include <graze/engine/compare/judge/rational/sure_pair.h>
#include <graze/engine/compare/referee.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/triangle_distance.h>
#include <gtest/gtest.h>
#include <tests/oracle/case_text.h>
#include <tests/oracle/category.h>

#include <limits>
#include <thread>
#include <vector>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze::compare {
namespace {

/// How many of the elements of a corpus are sure. Those that are must be true.
double share_of_sure(const oracle::Corpus<oracle::TrianglePair>& corpus, int count) {
  int sure = 0;
  for (int index = 0; index < count; ++index) {
    const oracle::TrianglePair pair = corpus.element(index);
    const std::optional<bool> says = surely_intersects(pair.a, pair.b);
    if (!says) continue;
    ++sure;
    const bool truth = referee_intersects(pair.a, pair.b);
    EXPECT_EQ(*says, truth) << corpus.name() << " element " << index << "\n"
                            << to_text(pair, truth);
  }
  return double(sure) / count;
}

TEST(SurePair, IsTrueOfEveryKindOfHardInput) {
  double at_random = 0;
  for (const auto& corpus : oracle::pair_corpora()) {
    const double sure = share_of_sure(corpus, 1500);
    if (corpus.name() == "random") at_random = sure;
  }
  EXPECT_GT(at_random, 0.999) << "else the judge is slow";
}

TEST(SurePairSlow, IsTrueOfEveryKindOfHardInput) {
  for (const auto& corpus : oracle::pair_corpora())
    share_of_sure(corpus, 60000);
}

TEST(SurePair, NothingThatTouchesIsSure) {
  const Triangle flat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const auto on = [&](const Eigen::Vector3d& point, double height) {
    return surely_intersects(flat, {point + Eigen::Vector3d(0, 0, height), {1, 1, 5}, {2, 1, 5}});
  };
  EXPECT_EQ(on({1, 1, 0}, 0), std::nullopt);
  EXPECT_EQ(on({1, 1, 0}, 0x1p-40), false);
  EXPECT_EQ(on({1, 1, 0}, -0x1p-40), true);
  EXPECT_EQ(on({2, 2, 0}, -0x1p-60), std::nullopt) << "on the long side";
  EXPECT_EQ(surely_intersects(flat, flat), std::nullopt);
  const Triangle point{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}};
  EXPECT_EQ(surely_intersects(flat, point), std::nullopt);
}

TEST(SurePair, NothingBeyondTheRangeIsSureOfAHit) {
  for (const double scale : {0x1p-600, 0x1p600, 0x1p1022}) {
    const Triangle flat{{0, 0, 0}, {scale, 0, 0}, {0, scale, 0}};
    const Triangle through{scale * Eigen::Vector3d(0.25, 0.25, -1),
                           scale * Eigen::Vector3d(0.25, 0.25, 1),
                           scale * Eigen::Vector3d(0.5, 0.25, 1)};
    EXPECT_EQ(surely_intersects(flat, through), std::nullopt) << scale;
    EXPECT_TRUE(referee_intersects(flat, through));
  }
}

TEST(SurePair, WhatLiesBeyondIsFartherThanThat) {
  RandomSource source(5);
  std::size_t beyond = 0;
  for (int run = 0; run < 3000; ++run) {
    const Triangle a = tests::random_soup({.count = 1}, source).triangle(0);
    const Triangle b = tests::random_soup({.count = 1, .centre = {1.5, 0, 0}}, source).triangle(0);
    const mpq_class square = squared_distance(exactly(a), exactly(b));
    const TriangleDistance nearest = distance(a, b);
    const Eigen::Vector3d way = source.uniform(1e-3, 1e3) * (nearest.point_b - nearest.point_a);
    const double root = rounded_root(square);
    for (const double share : {0.5, 1 - 0x1p-40, 1 - 0x1p-52, 1.0, 1 + 0x1p-52, 2.0}) {
      if (!lies_surely_beyond(a, b, way, share * root)) continue;
      ++beyond;
      EXPECT_GT(square, mpq_class(share * root) * mpq_class(share * root)) << share;
    }
    EXPECT_TRUE(root < 1e-6 || lies_surely_beyond(a, b, way, (1 - 0x1p-40) * root)) << run;
  }
  EXPECT_GT(beyond, 5000u);
  const Triangle flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_FALSE(lies_surely_beyond(flat, flat, {0, 0, 0}, 0));
  EXPECT_FALSE(lies_surely_beyond(flat, flat, {0, 0, 1}, 1));
}

/// All pairs, by the linear program alone.
std::vector<TrianglePair> all_hits(const Mesh& a, const Pose& pose_a, const Mesh& b,
                                   const Pose& pose_b) {
  std::vector<TrianglePair> hits;
  for (std::uint32_t i = 0; i < a.triangles().size(); ++i) {
    for (std::uint32_t j = 0; j < b.triangles().size(); ++j) {
      if (referee_intersects(place(pose_a, a.triangle(i)), place(pose_b, b.triangle(j))))
        hits.push_back({i, j});
    }
  }
  return hits;
}

/// Meshes of whole numbers far off, where a pose rounds much and many pairs merely touch.
TEST(MeshReferee, BoxesThatAPoseTurnsLoseNoPair) {
  RandomSource source(3);
  std::size_t hits = 0;
  for (int run = 0; run < 12; ++run) {
    const double shift = run % 3 == 0 ? 0 : run % 3 == 1 ? 1e7 : 1e15;
    const Mesh a = run % 2 == 0 ? tests::lattice_soup(30, 2, source)
                                : tests::random_soup({.count = 30}, source);
    const Mesh b = tests::lattice_soup(90, 2, source);  // held for the next question
    Pose pose_a = run % 4 < 2 ? Pose::Identity() : tests::random_pose(0.5, source);
    Pose pose_b = run < 4 ? pose_a : tests::random_pose(0.5, source);
    pose_a.translation() += Eigen::Vector3d(shift, -shift, shift);
    pose_b.translation() += Eigen::Vector3d(shift, -shift, shift);
    const std::vector<TrianglePair> expected = all_hits(a, pose_a, b, pose_b);
    const MeshReferee referee({a, pose_a}, {b, pose_b});
    EXPECT_EQ(referee.find_hits(), expected) << run;
    EXPECT_EQ(referee.find_hit().has_value(), !expected.empty()) << run;
    hits += expected.size();
  }
  EXPECT_GT(hits, 200u);
}

TEST(MeshReferee, ManyThreadsShareWhatIsHeldOfAMesh) {
  const Mesh ball = tests::make_sphere(1.0, 6, 10);
  const Mesh other = tests::make_sphere(0.7, 6, 10);
  std::vector<std::vector<TrianglePair>> found(4);
  std::vector<std::thread> threads;
  const auto pose_of = [](int k) {
    Pose pose = Pose::Identity();
    pose.translation().x() = 0.4 + 0.2 * k;
    return pose;
  };
  for (int k = 0; k < 4; ++k) {
    threads.emplace_back([&, k] {
      found[k] = MeshReferee({ball}, {other, pose_of(k)}).find_hits();
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  for (int k = 0; k < 4; ++k)
    EXPECT_EQ(found[k], all_hits(ball, Pose::Identity(), other, pose_of(k))) << k;
}

}  // namespace
}  // namespace graze::compare
