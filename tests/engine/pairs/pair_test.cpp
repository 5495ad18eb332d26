#include <graze/bvh/error.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/files/failed_case.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using tests::distorted;
using tests::random_pose;
using tests::random_soup;

std::vector<TrianglePair> brute_force(const PlacedMesh& a, const PlacedMesh& b) {
  std::vector<TrianglePair> pairs;
  for (std::uint32_t i = 0; i < a.mesh.triangles().size(); ++i) {
    const Triangle placed = place(a.pose, a.mesh.triangle(i));
    for (std::uint32_t j = 0; j < b.mesh.triangles().size(); ++j) {
      if (intersects(placed, place(b.pose, b.mesh.triangle(j)))) pairs.push_back({i, j});
    }
  }
  return pairs;
}

/// Laws 9 and 4: the tree changes nothing, nor does the order of the meshes.
std::size_t expect_brute_force(const PlacedMesh& a, const PlacedMesh& b) {
  const std::vector<TrianglePair> expected = brute_force(a, b);
  const tests::CaseOnFailure keep([&] {
    return tests::by_brute_force(to_case(a, b, TrianglePairs{expected, Completeness::Complete}));
  });
  const TrianglePairs found = find_triangle_pairs(a, b);
  EXPECT_EQ(found.pairs, expected);
  EXPECT_EQ(found.completeness, Completeness::Complete);
  EXPECT_EQ(intersects(a, b), !expected.empty());
  EXPECT_EQ(intersects(b, a), !expected.empty());
  for (const PairVolume volume : kPairVolumes) {
    EXPECT_EQ(find_triangle_pairs(a, b, {.volume = volume}).pairs, expected) << name_of(volume);
    EXPECT_EQ(intersects(b, a, {.volume = volume}), !expected.empty()) << name_of(volume);
  }
  std::vector<TrianglePair> mirrored;
  for (TrianglePair pair : find_triangle_pairs(b, a))
    mirrored.push_back({pair.b, pair.a});
  std::sort(mirrored.begin(), mirrored.end());
  EXPECT_EQ(mirrored, expected);
  return expected.size();
}

TEST(Law9, SoupsInRandomPoses) {
  RandomSource source(1);
  std::size_t pairs = 0;
  for (int n = 0; n < 400; ++n) {
    const Mesh a = random_soup({.count = 80}, source);
    const Mesh b = random_soup({.count = 50, .extent = 0.5, .size = 0.1}, source);
    const Pose pose_a = random_pose(0.5, source), pose_b = random_pose(0.5, source);
    pairs += expect_brute_force({a, pose_a}, {b, pose_b});
  }
  EXPECT_GT(pairs, 500u);
}

TEST(Law9, LatticeSoupsTouchEverywhere) {
  RandomSource source(2);
  std::size_t pairs = 0;
  for (int n = 0; n < 40; ++n) {
    const Mesh a = tests::lattice_soup(50, 3, source);
    const Mesh b = tests::lattice_soup(50, 3, source);
    Pose quarter = Pose::Identity();
    quarter.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    quarter.translation() = source.lattice_point(-4, 4);
    pairs += expect_brute_force({a}, {b, quarter});
  }
  EXPECT_GT(pairs, 5000u);
}

TEST(Law9, AtHugeOffsets) {
  RandomSource source(3);
  std::size_t pairs = 0;
  for (double offset : {1e6, 1e9, 1e12, 1e15}) {
    for (int n = 0; n < 24; ++n) {
      const Eigen::Vector3d centre = Eigen::Vector3d(1, -0.7, 0.3) * offset;
      const Mesh here = random_soup({.count = 60}, source);
      const Mesh there = random_soup({.count = 60, .centre = centre}, source);
      Pose moved = random_pose(0.3, source);
      moved.translation() += centre;
      pairs += expect_brute_force({here, moved}, {there});
      Pose back = random_pose(0, source);
      back.translation() = -(back.linear() * centre);
      pairs += expect_brute_force({there, back}, {here});
      pairs += expect_brute_force({here, moved}, {here, moved});
    }
  }
  EXPECT_GT(pairs, 5000u);
}

TEST(Law9, AtExtremeScales) {
  RandomSource source(4);
  for (double scale : {1e-310, 1e-300, 1e-160, 1e-20, 1e20, 1e150, 1e300}) {
    std::size_t pairs = 0;
    for (int n = 0; n < 16; ++n) {
      const Mesh a = random_soup({.count = 40, .extent = scale, .size = 0.3 * scale}, source);
      const Mesh b = random_soup({.count = 40, .extent = scale, .size = 0.3 * scale}, source);
      const Pose pose_a = random_pose(0.3 * scale, source),
                 pose_b = random_pose(0.3 * scale, source);
      pairs += expect_brute_force({a, pose_a}, {b, pose_b});
    }
    EXPECT_GT(pairs, 20u) << scale;
  }
}

TEST(Law9, MixedScales) {
  RandomSource source(5);
  std::size_t pairs = 0;
  for (double scale : {1e-200, 1e-12, 1e-6, 1e6, 1e200}) {
    for (int n = 0; n < 24; ++n) {
      const Mesh a = random_soup({.count = 50}, source);
      const Mesh b = random_soup({.count = 30, .extent = scale, .size = scale}, source);
      // One corner of A on the centre of B, so that they meet at any scale.
      Pose pose = random_pose(0, source);
      pose.translation() = -place(pose, a.vertices()[3]);
      pairs += expect_brute_force({a, pose}, {b, random_pose(0, source)});
    }
  }
  EXPECT_GT(pairs, 50u);
}

TEST(Law9, PosesAtTheDoorsLimit) {
  RandomSource source(6);
  std::size_t pairs = 0;
  for (int n = 0; n < 400; ++n) {
    const Mesh a = random_soup({.count = 60, .extent = 1, .size = 0.1}, source);
    const Mesh b = random_soup({.count = 60, .extent = 1, .size = 0.1}, source);
    const Pose pose_a = distorted(random_pose(0.1, source), 1e-6, source),
               pose_b = distorted(random_pose(0.1, source), 1e-6, source);
    pairs += expect_brute_force({a, pose_a}, {b, pose_b});
  }
  EXPECT_GT(pairs, 100u);
}

/// A triangle that touches the mesh in one placed vertex and is beyond it in that direction: the
/// tightest case there is for a box that must not be pruned.
Mesh kissing(const Eigen::Vector3d& placed, const Eigen::Vector3d& outward, double size) {
  const Eigen::Vector3d side = outward.unitOrthogonal();
  const std::vector<Eigen::Vector3d> vertices{placed, placed + size * (outward + side),
                                              placed + size * (outward - side)};
  const std::vector<TriangleIndices> triangles{{0, 1, 2}};
  return Mesh(vertices, triangles);
}

TEST(Law5, ATouchingVertexIsNeverPruned) {
  RandomSource source(7);
  for (int n = 0; n < 3000; ++n) {
    const double offset = n % 3 == 0 ? 0 : std::pow(10.0, source.integer(0, 12));
    const Mesh mesh = random_soup(
        {.count = 8, .centre = source.vector(-1, 1) * (n % 2 == 0 ? 0 : offset)}, source);
    Pose pose = random_pose(offset, source);
    if (n % 5 == 0) pose = distorted(pose, 1e-6, source);
    const Eigen::Vector3d outward = source.vector(-1, 1).normalized();
    // The extreme vertex in that direction, among those that triangles use.
    Eigen::Vector3d extreme = place(pose, mesh.triangle(0).a);
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
      const Triangle t = place(pose, mesh.triangle(i));
      for (const Eigen::Vector3d& corner : {t.a, t.b, t.c}) {
        if (corner.dot(outward) > extreme.dot(outward)) extreme = corner;
      }
    }
    const Mesh probe = kissing(extreme, outward, std::pow(10.0, source.integer(-3, 3)));
    ASSERT_TRUE(intersects({mesh, pose}, {probe})) << n;
    ASSERT_TRUE(intersects({probe}, {mesh, pose})) << n;
    for (const PairVolume volume : kPairVolumes) {
      ASSERT_TRUE(intersects({mesh, pose}, {probe}, {.volume = volume})) << n << name_of(volume);
      ASSERT_TRUE(intersects({probe}, {mesh, pose}, {.volume = volume})) << n << name_of(volume);
    }
    ASSERT_EQ(find_triangle_pairs({mesh, pose}, {probe}).pairs, brute_force({mesh, pose}, {probe}))
        << n;
  }
}

TEST(Pair, LimitsGiveTruePairsAndSaySo) {
  const Mesh sphere = tests::make_sphere(1, 20, 20);
  Pose pose = Pose::Identity();
  pose.translation() << 0.3, 0.2, 0.1;
  const TrianglePairs all = find_triangle_pairs({sphere}, {sphere, pose});
  ASSERT_GT(all.size(), 50u);
  for (std::size_t limit :
       {std::size_t{0}, std::size_t{1}, std::size_t{17}, all.size(), all.size() + 1}) {
    const TrianglePairs some = find_triangle_pairs({sphere}, {sphere, pose}, {.limit = limit});
    EXPECT_EQ(some.size(), std::min(limit, all.size()));
    EXPECT_TRUE(std::is_sorted(some.begin(), some.end()));
    EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
    EXPECT_EQ(some.completeness,
              limit < all.size() ? Completeness::LimitReached : Completeness::Complete);
  }
}

TEST(Pair, WorkFollowsTheNeed) {
  const Mesh sphere = tests::make_sphere(1, 40, 40);
  const auto work_at = [&](double distance) {
    Pose pose = Pose::Identity();
    pose.translation().x() = distance;
    Work work;
    intersects({sphere}, {sphere, pose}, &work);
    return work;
  };
  const Work far = work_at(10);
  EXPECT_EQ(far.volume_tests, 1u);
  EXPECT_EQ(far.volume_rejections, 1u);
  EXPECT_EQ(far.triangle_tests, 0u);
  EXPECT_EQ(far.trees_built, 0u);
  const Work deep = work_at(0.5);
  EXPECT_EQ(deep.trees_built, 1u) << "both are the same mesh";
  EXPECT_GT(deep.filter_tests, 0u);
  Work pairs;
  Pose pose = Pose::Identity();
  pose.translation().x() = 0.5;
  find_triangle_pairs({sphere}, {sphere, pose}, {}, &pairs);
  EXPECT_LT(20 * deep.filter_tests, pairs.filter_tests) << "a boolean stops at its first yes";
}

TEST(Pair, WhatSurelyCrossesIsNotPlaced) {
  const Mesh sphere = tests::make_sphere(1, 40, 40);
  RandomSource source(521);
  Work work;
  std::size_t found = 0;
  for (int n = 0; n < 10; ++n) {
    const Pose pose = tests::random_pose(0.5, source);
    found += find_triangle_pairs({sphere}, {sphere, pose}, {}, &work).size();
  }
  EXPECT_GT(found, 1000u);
  EXPECT_LT(work.triangle_tests, found / 2) << "twice as many as are found, if all are placed";
  EXPECT_LT(work.exact_tests, 10u);
}

TEST(Pair, ABooleanStopsAtItsFirstYesWhateverPrunes) {
  const Mesh sphere = tests::make_sphere(1, 40, 40);
  Pose pose = Pose::Identity();
  pose.translation().x() = 0.5;
  for (const PairVolume volume : kPairVolumes) {
    Work yes;
    Work all;
    ASSERT_TRUE(intersects({sphere}, {sphere, pose}, {.volume = volume}, &yes));
    find_triangle_pairs({sphere}, {sphere, pose}, {.volume = volume}, &all);
    EXPECT_LT(10 * yes.triangle_tests, all.triangle_tests) << name_of(volume);
  }
}

TEST(Pair, ABooleanTriesTheNearestLeavesFirstAndNoMore) {
  const Mesh sphere = tests::make_sphere(1, 40, 40);
  Work work;
  for (int i = 0; i < 50; ++i) {
    Pose pose = Pose::Identity();
    pose.linear() =
        Eigen::AngleAxisd(0.1 * i, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    pose.translation() = Eigen::Vector3d(1.2 + 0.01 * i, 0.3, 0.2);
    EXPECT_TRUE(intersects({sphere}, {sphere, pose}, {}, &work));
  }
  EXPECT_LT(work.filter_tests, 50u * 32) << "two pairs of full leaves in each query";
}

TEST(Pair, SkinsAreMadeByTheFirstQueryThatNeedsThem) {
  const Mesh sphere = tests::make_sphere(1, 20, 20);
  const auto work_of = [&](PairVolume volume) {
    Work work;
    intersects({sphere}, {sphere}, {.volume = volume}, &work);
    return work;
  };
  EXPECT_EQ(work_of(PairVolume::Aabb).skins_built, 0u);
  EXPECT_EQ(work_of(PairVolume::Sphere).skins_built, 1u) << "both are the same mesh";
  EXPECT_EQ(work_of(PairVolume::Sphere).skins_built, 0u);
  EXPECT_EQ(work_of(PairVolume::Obb).skins_built, 1u);
  EXPECT_EQ(work_of(PairVolume::Obb).skins_built, 0u);
  EXPECT_EQ(work_of(PairVolume::KDop).skins_built, 1u);
  EXPECT_EQ(work_of(PairVolume::KDop).trees_built, 0u);
}

TEST(Pair, TighterVolumesPruneMore) {
  const Mesh torus = tests::make_torus(1, 0.3, 60, 30);
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  pose.translation() << 1.2, 0.4, 0.3;
  const auto tests_of = [&](PairVolume volume) {
    Work work;
    find_triangle_pairs({torus}, {torus, pose}, {.volume = volume}, &work);
    return work.triangle_tests;
  };
  EXPECT_LT(tests_of(PairVolume::Obb), tests_of(PairVolume::Aabb));
  EXPECT_LT(tests_of(PairVolume::KDop), tests_of(PairVolume::Sphere));
}

TEST(Law10Pair, AVolumeThatIsNoneIsRefused) {
  const Mesh sphere = tests::make_sphere(1, 4, 4);
  EXPECT_THROW(intersects({sphere}, {sphere}, {.volume = static_cast<PairVolume>(99)}), InputError);
}

TEST(Pair, AMeshWhollyInsideAnotherDoesNotTouchIt) {
  const Mesh outer = tests::make_sphere(2, 20, 20);
  const Mesh inner = tests::make_sphere(1, 20, 20);
  EXPECT_FALSE(intersects({outer}, {inner}));
}

TEST(Law10Pair, BadPosesAreRefusedAndNamed) {
  const Mesh mesh = tests::make_sphere(1, 4, 4);
  Pose bad = Pose::Identity();
  bad.linear() *= 1.1;
  try {
    intersects({mesh}, {mesh, bad});
    FAIL();
  } catch (const PoseError& error) {
    EXPECT_EQ(std::string(error.what()).find("pose of mesh B: not a rotation"), 0u) << error.what();
  }
  EXPECT_THROW(find_triangle_pairs({mesh, bad}, {mesh}), PoseError);
  for (int i = 0; i < 16; ++i) {
    for (const double bad_entry : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
      Pose pose = Pose::Identity();
      pose.data()[i] = bad_entry;
      EXPECT_THROW(intersects({mesh, pose}, {mesh}), PoseError) << i;
      EXPECT_THROW(intersects({mesh}, {mesh, pose}), PoseError) << i;
    }
  }
}

}  // namespace
}  // namespace graze
