#include <graze/bvh/error.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/pair_memory.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/self.h>
#include <graze/engine/mesh/volume_query.h>
#include <graze/narrowphase/crossing.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

std::vector<TrianglePair> brute_force(const PlacedMesh& a, const PlacedMesh& b) {
  std::vector<TrianglePair> pairs;
  for (std::uint32_t i = 0; i < a.mesh.triangles().size(); ++i) {
    for (std::uint32_t j = 0; j < b.mesh.triangles().size(); ++j) {
      if (crosses(place(a.pose, a.mesh.triangle(i)), place(b.pose, b.mesh.triangle(j))))
        pairs.push_back({i, j});
    }
  }
  return pairs;
}

std::size_t expect_brute_force(const PlacedMesh& a, const PlacedMesh& b) {
  const std::vector<TrianglePair> expected = brute_force(a, b);
  for (const PairVolume volume : kPairVolumes) {
    const TrianglePairs found =
        find_triangle_pairs(a, b, {.volume = volume, .touch = Touch::Exclude});
    EXPECT_EQ(found.pairs, expected) << name_of(volume);
    EXPECT_EQ(found.completeness, Completeness::Complete);
    for (const bool is_swapped : {false, true}) {
      EXPECT_EQ(intersects(is_swapped ? b : a, is_swapped ? a : b,
                           {.volume = volume, .hit = Hit::Crossing}),
                !expected.empty())
          << name_of(volume);
    }
  }
  return expected.size();
}

TEST(TouchPolicyMeshes, SoupsInRandomPosesAreBruteForce) {
  RandomSource source(1);
  std::size_t pairs = 0;
  for (int n = 0; n < 60; ++n) {
    const Mesh a = tests::random_soup({.count = 80}, source);
    const Mesh b = tests::random_soup({.count = 50, .extent = 0.5, .size = 0.2}, source);
    const Pose pose_a = tests::random_pose(0.5, source);
    pairs += expect_brute_force({a, pose_a}, {b, tests::random_pose(0.5, source)});
  }
  EXPECT_GT(pairs, 200u);
}

TEST(TouchPolicyMeshes, LatticeSoupsAreBruteForce) {
  RandomSource source(2);
  std::size_t crossing = 0;
  std::size_t touching = 0;
  for (int n = 0; n < 20; ++n) {
    const Mesh a = tests::lattice_soup(50, 3, source);
    const Mesh b = tests::lattice_soup(50, 3, source);
    Pose quarter = Pose::Identity();
    quarter.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    quarter.translation() = source.lattice_point(-2, 2);
    crossing += expect_brute_force({a}, {b, quarter});
    touching += find_triangle_pairs({a}, {b, quarter}).size();
  }
  EXPECT_GT(crossing, 1000u);
  EXPECT_GT(touching, crossing + 1000);
}

TEST(TouchPolicyMeshes, ABoxOnABoxTouchesAndDoesNotCross) {
  const Mesh box = tests::make_box({1, 1, 1});
  Pose above = Pose::Identity();
  above.translation() << 0.25, 0.5, 2;
  EXPECT_TRUE(intersects({box}, {box, above}));
  EXPECT_FALSE(intersects({box}, {box, above}, {.hit = Hit::Crossing}));
  above.translation().z() = 2 - 0x1p-52;
  EXPECT_TRUE(intersects({box}, {box, above}, {.hit = Hit::Crossing})) << "one double lower";
}

TEST(TouchPolicyMeshes, LimitsHold) {
  const Mesh sphere = tests::make_sphere(1, 20, 20);
  Pose pose = Pose::Identity();
  pose.translation() << 0.3, 0.2, 0.1;
  const TrianglePairs all =
      find_triangle_pairs({sphere}, {sphere, pose}, {.touch = Touch::Exclude});
  ASSERT_GT(all.size(), 20u);
  const TrianglePairs some =
      find_triangle_pairs({sphere}, {sphere, pose}, {.limit = 7, .touch = Touch::Exclude});
  EXPECT_EQ(some.size(), 7u);
  EXPECT_EQ(some.completeness, Completeness::LimitReached);
  EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
}

template <typename Settings>
concept HasTouch = requires(Settings settings) {
  settings.touch;
};
template <typename Settings>
concept HasHit = requires(Settings settings) {
  settings.hit;
};
template <typename Settings>
concept HasInterior = requires(Settings settings) {
  settings.interior;
};
template <typename Settings>
concept HasVolume = requires(Settings settings) {
  settings.volume;
};
template <typename Settings>
concept HasWideVolume = requires(Settings settings) {
  settings.volume = PairVolume::WideObb;
};

template <typename Settings>
concept HasThreads = requires(Settings settings) {
  settings.threads;
};
template <typename Settings>
concept HasLimit = requires(Settings settings) {
  settings.limit;
};

// What a query would have to ignore or refuse does not compile.
static_assert(HasHit<QuerySettings> && HasWideVolume<QuerySettings>);
static_assert(!HasTouch<QuerySettings> && !HasInterior<QuerySettings>);
static_assert(!HasVolume<MemoryQuerySettings> && !HasVolume<MemoryPairSettings>);
static_assert(!HasThreads<PairSettings> && !HasThreads<MemoryPairSettings>);
static_assert(HasThreads<SharedPairSettings> && HasTouch<SharedPairSettings>);
static_assert(!HasLimit<SharedPairSettings> && !HasVolume<SharedPairSettings>);
static_assert(HasInterior<VolumeQuerySettings> && !HasHit<VolumeQuerySettings>);
static_assert(!HasTouch<VolumeQuerySettings> && !HasWideVolume<VolumeQuerySettings>);
static_assert(!HasTouch<TriangleSettings> && !HasWideVolume<TriangleSettings>);
static_assert(!HasTouch<SelfQuerySettings> && !HasInterior<SelfQuerySettings>);
static_assert(!HasWideVolume<SelfQuerySettings> && !HasWideVolume<SelfSettings>);
static_assert(!HasTouch<IntersectionSettings> && !HasHit<IntersectionSettings>);

TEST(Law4PairThreads, ManyThreadsFindWhatOneDoes) {
  const Mesh a = tests::make_torus(1, 0.25, 48, 24);
  const Pose pose = tests::at(0.5, 0.25, 0.125);
  for (const Touch touch : {Touch::Include, Touch::Exclude}) {
    const TrianglePairs expected = find_triangle_pairs({a}, {a, pose}, {.touch = touch});
    ASSERT_GT(expected.size(), 50u);
    PairMemory memory;
    for (const int threads : {0, 1, 2, 3}) {
      Work work;
      EXPECT_EQ(find_triangle_pairs({a}, {a, pose}, {.threads = threads, .touch = touch}, &work),
                expected);
      EXPECT_GT(work.volume_tests, 0u);
      const SharedPairSettings settings{.threads = threads, .touch = touch};
      EXPECT_EQ(find_triangle_pairs({a}, {a, pose}, memory, settings), expected);
      EXPECT_TRUE(find_triangle_pairs({a}, {a, tests::at(9)}, settings).empty());
    }
  }
  EXPECT_THROW(find_triangle_pairs({a}, {a}, {.threads = -1}), InputError);
  PairMemory memory;
  EXPECT_THROW(find_triangle_pairs({a}, {a}, memory, {.threads = -1}), InputError);
}

TEST(Law10TouchPolicy, WhatIsNoneIsRefused) {
  const Mesh box = tests::make_box({1, 1, 1});
  EXPECT_THROW(intersects({box}, {box}, {.hit = static_cast<Hit>(9)}), InputError);
  EXPECT_THROW(find_triangle_pairs({box}, {box}, {.touch = static_cast<Touch>(9)}), InputError);
}

}  // namespace
}  // namespace graze
