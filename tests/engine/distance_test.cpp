#include <graze/bvh/error.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/triangle_distance.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "tests/files/failed_case.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using tests::distorted;
using tests::random_pose;
using tests::random_soup;

MeshDistance brute_force(const PlacedMesh& a, const PlacedMesh& b) {
  MeshDistance best{HUGE_VAL, {}, {}, {}};
  for (std::uint32_t i = 0; i < a.mesh.triangles().size(); ++i) {
    const Triangle placed = place(a.pose, a.mesh.triangle(i));
    for (std::uint32_t j = 0; j < b.mesh.triangles().size(); ++j) {
      const TriangleDistance found = distance(placed, place(b.pose, b.mesh.triangle(j)));
      if (found.distance < best.distance || (i == 0 && j == 0)) {
        best = {found.distance, found.point_a, found.point_b, {i, j}};
      }
    }
  }
  return best;
}

bool are_bits_equal(const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
  return std::memcmp(p.data(), q.data(), 3 * sizeof(double)) == 0;
}

void expect_same(const MeshDistance& found, const MeshDistance& expected) {
  EXPECT_EQ(found.distance, expected.distance);
  EXPECT_TRUE(are_bits_equal(found.point_a, expected.point_a));
  EXPECT_TRUE(are_bits_equal(found.point_b, expected.point_b));
  EXPECT_EQ(found.pair, expected.pair);
}

/// Of meshes that meet not the lowest pair is named, but the one that a limited query begins with.
MeshDistance expect_one_that_meets(const PlacedMesh& a, const PlacedMesh& b) {
  const MeshDistance found = distance(a, b);
  const Triangle triangle_a = place(a.pose, a.mesh.triangle(found.pair.a));
  const Triangle triangle_b = place(b.pose, b.mesh.triangle(found.pair.b));
  EXPECT_TRUE(intersects(triangle_a, triangle_b));
  const TriangleDistance of_pair = distance(triangle_a, triangle_b);
  EXPECT_EQ(found.distance, 0);
  EXPECT_EQ(found.pair, find_triangle_pairs(a, b, {.limit = 1}).pairs.at(0));
  EXPECT_TRUE(are_bits_equal(found.point_a, of_pair.point_a));
  EXPECT_TRUE(are_bits_equal(found.point_b, of_pair.point_b));
  return found;
}

/// Law 9: the trees change nothing, nor does a hint. Returns the distance.
double expect_brute_force(const PlacedMesh& a, const PlacedMesh& b) {
  MeshDistance expected = brute_force(a, b);
  if (expected.distance == 0) expected = expect_one_that_meets(a, b);
  const tests::CaseOnFailure keep([&] { return tests::by_brute_force(to_case(a, b, expected)); });
  expect_same(distance(a, b), expected);
  const TrianglePair last{static_cast<std::uint32_t>(a.mesh.triangles().size() - 1),
                          static_cast<std::uint32_t>(b.mesh.triangles().size() - 1)};
  expect_same(distance(a, b, {.hint = expected.pair}), expected);
  expect_same(distance(a, b, {.hint = last}), expected);
  EXPECT_EQ(distance(b, a).distance, expected.distance);
  const double d = expected.distance;
  EXPECT_TRUE(within(a, b, d));
  EXPECT_TRUE(within(b, a, d, {.hint = TrianglePair{last.b, last.a}}));
  EXPECT_TRUE(within(a, b, 1.5 * d));
  EXPECT_EQ(within(a, b, std::nextafter(d, 0.0)), d == 0);
  EXPECT_EQ(within(a, b, d / 2, {.hint = expected.pair}), d == 0);
  return d;
}

TEST(Law9MeshDistance, SoupsInRandomPoses) {
  RandomSource source(91);
  int apart = 0;
  for (int n = 0; n < 200; ++n) {
    const Mesh a = random_soup({.count = 40}, source);
    const Mesh b = random_soup({.count = 30, .extent = 0.5, .size = 0.1}, source);
    const Pose pose_a = random_pose(1.5, source), pose_b = random_pose(1.5, source);
    const double d = expect_brute_force({a, pose_a}, {b, pose_b});
    apart += d > 0;
  }
  EXPECT_GT(apart, 100);
  EXPECT_LT(apart, 200);
}

TEST(Law9MeshDistance, LatticesTieEverywhere) {
  RandomSource source(92);
  int apart = 0;
  for (int n = 0; n < 40; ++n) {
    const Mesh a = tests::lattice_soup(20, 2, source);
    const Mesh b = tests::lattice_soup(20, 2, source);
    Pose quarter = Pose::Identity();
    quarter.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    quarter.translation() = source.lattice_point(-7, 7);
    apart += expect_brute_force({a}, {b, quarter}) > 0;
  }
  EXPECT_GT(apart, 10);
}

TEST(Law9MeshDistance, SpheresShareTheirNearestVertices) {
  const Mesh sphere = tests::make_sphere(1, 12, 12);
  Pose pose = Pose::Identity();
  pose.translation().z() = 2.5;
  EXPECT_EQ(expect_brute_force({sphere}, {sphere, pose}), 0.5);
  pose.translation() << 3, 0, 0;
  expect_brute_force({sphere}, {sphere, pose});
}

TEST(Law9MeshDistance, AtHugeOffsets) {
  RandomSource source(93);
  for (double offset : {1e6, 1e9, 1e12, 1e15}) {
    for (int n = 0; n < 10; ++n) {
      const Eigen::Vector3d centre = Eigen::Vector3d(1, -0.7, 0.3) * offset;
      const Mesh here = random_soup({.count = 20}, source);
      const Mesh there = random_soup({.count = 20, .centre = centre}, source);
      Pose moved = random_pose(3, source);
      moved.translation() += centre;
      expect_brute_force({here, moved}, {there});
      expect_brute_force({here}, {there});
    }
  }
}

TEST(Law9MeshDistance, AtExtremeAndMixedScales) {
  RandomSource source(94);
  for (double scale : {1e-310, 1e-300, 1e-160, 1e-20, 1e20, 1e150, 1e300}) {
    for (int n = 0; n < 3; ++n) {
      const Mesh a = random_soup({.count = 12, .extent = scale, .size = 0.3 * scale}, source);
      const Mesh b = random_soup({.count = 12, .extent = scale, .size = 0.3 * scale}, source);
      const Mesh c = random_soup({.count = 12}, source);
      const Pose pose_a = random_pose(2 * scale, source), pose_b = random_pose(2 * scale, source);
      expect_brute_force({a, pose_a}, {b, pose_b});
      const Pose turned_a = random_pose(0, source), pose_c = random_pose(2, source);
      expect_brute_force({a, turned_a}, {c, pose_c});
    }
  }
}

// In units of their own size they are so far apart that squares overflow a float.
TEST(Law9MeshDistance, OfTinyMeshesFarApart) {
  RandomSource source(97);
  for (const double size : {1e-9, 1e-12, 1e-18, 1e-19, 1e-20, 1e-38, 1e-150}) {
    for (int n = 0; n < 5; ++n) {
      const Mesh a = random_soup({.count = 9, .extent = size, .size = size}, source);
      const Mesh b = random_soup(
          {.count = 9, .extent = size, .size = size, .centre = {1e-10, -3, n * 1.0}}, source);
      expect_brute_force({a}, {b});
      const Pose pose_a = random_pose(4, source), pose_b = random_pose(4, source);
      expect_brute_force({a, pose_a}, {b, pose_b});
    }
  }
}

// In the smaller one's units squares overflow a float, in the larger one's they do not: what
// overflowed says nothing of how near the nearest corners are.
TEST(Law9MeshDistance, OfTinyMeshesOfUnlikeSizesFarApart) {
  RandomSource source(99);
  for (const double size : {0x1p-60, 0x1p-64, 0x1p-80}) {
    for (int n = 0; n < 10; ++n) {
      const Mesh a = random_soup({.count = 24, .extent = 0x1p-27, .size = 0x1p-31}, source);
      const Mesh b = random_soup({.count = 3, .extent = size, .size = size}, source);
      expect_brute_force({a}, {b, random_pose(4, source)});
      expect_brute_force({b}, {a, random_pose(4, source)});
    }
  }
}

// A speck beside a giant: in the speck's units the giant is more than a float can hold.
TEST(Law9MeshDistance, OfASpeckAndAGiant) {
  RandomSource source(98);
  for (const double giant : {1e15, 1e19, 1e22, 1e30, 1e100}) {
    for (const double speck : {1e-30, 1e-20, 1e-19, 1e-10}) {
      for (int n = 0; n < 3; ++n) {
        const Mesh a = random_soup({.count = 40, .extent = giant, .size = 0.01 * giant}, source);
        const Mesh b = random_soup({.count = 7, .extent = speck, .size = speck}, source);
        const Pose pose_a = random_pose(3, source), pose_b = random_pose(3, source);
        expect_brute_force({a, pose_a}, {b, pose_b});
        const Pose far_a = random_pose(giant, source), far_b = random_pose(3 * giant, source);
        expect_brute_force({a, far_a}, {b, far_b});
      }
    }
  }
  for (int ratio = 118; ratio < 136; ++ratio) {
    const double speck = std::ldexp(0x1p64, -ratio);
    for (int n = 0; n < 4; ++n) {
      const Mesh a = random_soup({.count = 40, .extent = 0x1p62, .size = 0x1p50}, source);
      const Mesh b = random_soup({.count = 3, .extent = speck, .size = speck}, source);
      expect_brute_force({a}, {b});
      const Pose pose_a = random_pose(0x1p63, source), pose_b = random_pose(3, source);
      expect_brute_force({a, pose_a}, {b, pose_b});
    }
  }
}

TEST(Law9MeshDistance, PosesAtTheDoorsLimit) {
  RandomSource source(95);
  for (int n = 0; n < 100; ++n) {
    const Mesh a = random_soup({.count = 30, .extent = 1, .size = 0.1}, source);
    const Mesh b = random_soup({.count = 30, .extent = 1, .size = 0.1}, source);
    const Pose pose_a = distorted(random_pose(2, source), 1e-6, source),
               pose_b = distorted(random_pose(2, source), 1e-6, source);
    expect_brute_force({a, pose_a}, {b, pose_b});
  }
}

// One shell inside another: much is nearly nearest, and a walk is long enough to align nodes.
TEST(Law9MeshDistance, OfShellsThatFaceEachOther) {
  RandomSource source(99);
  for (const double scale : {1e-20, 1.0, 1e20}) {
    const Mesh inner = tests::make_sphere(scale, 18, 18);
    const Mesh outer = tests::make_sphere(1.06 * scale, 16, 20);
    const Pose at = distorted(random_pose(0.02 * scale, source), 1e-6, source);
    EXPECT_GT(expect_brute_force({inner, at}, {outer, random_pose(0.01 * scale, source)}), 0);
    Work work;
    distance({inner, at}, {outer}, {}, &work);
    EXPECT_GT(work.volume_tests, 1000u);
  }
}

// Far from where the common frame begins, and with units that differ.
TEST(Law9MeshDistance, OfASmallShellInALargeOne) {
  RandomSource source(100);
  for (const double size : {0.9, 0.1, 1e-3, 1e-9}) {
    const Mesh small = tests::make_sphere(size, 18, 18);
    const Mesh large = tests::make_sphere(1, 16, 20);
    Pose aside = random_pose(0, source);
    aside.translation() = (0.95 - size) * source.vector(-1, 1).normalized();
    expect_brute_force({small, aside}, {large, random_pose(0, source)});
    for (int n = 0; n < 4; ++n) {
      const Pose pose = random_pose(3, source);
      expect_brute_force({small, random_pose(1e3, source)}, {large, pose});
    }
  }
}

// Lengths in the frame of the boxes are off by a part in a million, of a distance a million times
// the meshes' size: by as much as one pair of triangles is nearer than another.
TEST(Law9MeshDistance, FarApartInFramesThatAreNotQuiteRotations) {
  RandomSource source(96);
  for (int n = 0; n < 40; ++n) {
    const Mesh a = random_soup({.count = 12, .extent = 1e-3, .size = 3e-4}, source);
    const Mesh b = random_soup({.count = 12, .extent = 1e-3, .size = 3e-4}, source);
    Pose pose_a = random_pose(0, source), pose_b = random_pose(0, source);
    pose_a.linear() *= 1 + (n % 2 == 0 ? 0.49e-6 : -0.49e-6);
    pose_b.linear() *= 1 + (n % 4 < 2 ? 0.49e-6 : -0.49e-6);
    pose_b.translation() = 1000 * source.vector(-1, 1).normalized();
    expect_brute_force({a, pose_a}, {b, pose_b});
  }
}

TEST(MeshDistance, WorkFollowsTheNeed) {
  const Mesh sphere = tests::make_sphere(1, 60, 60);
  Pose pose = Pose::Identity();
  pose.translation() << 2, 1.5, 1;
  Work all, far, near;
  const MeshDistance found = distance({sphere}, {sphere, pose}, {}, &all);
  EXPECT_LT(all.triangle_tests, 20000u) << "of 50 million";
  EXPECT_FALSE(within({sphere}, {sphere, pose}, found.distance / 4, {}, &far));
  EXPECT_TRUE(within({sphere}, {sphere, pose}, found.distance * 4, {}, &near));
  EXPECT_EQ(far.triangle_tests, 0u);
  EXPECT_LT(far.volume_tests, all.volume_tests);
  EXPECT_LT(near.volume_tests, all.volume_tests);
}

// A walk begins with what could be much nearer, and looks at the rest once: not anew from the root.
TEST(MeshDistance, NothingIsLookedAtTwice) {
  RandomSource source(101);
  const Mesh sphere = tests::make_sphere(1, 60, 60);
  Work work;
  for (int n = 0; n < 20; ++n) {
    Pose aside = random_pose(0, source);
    aside.translation() = 2.01 * source.vector(-1, 1).normalized();
    distance({sphere}, {sphere, aside}, {}, &work);
  }
  EXPECT_LT(work.volume_tests, 54000u) << "62,900 if the rest is looked at from the root on";
}

// Of meshes that meet one pair is the answer: little is looked at behind the first one that meets.
TEST(MeshDistance, OfMeshesThatMeetEndsWithTheFirstPair) {
  const Mesh sphere = tests::make_sphere(1, 60, 60);
  Work work;
  for (int i = 0; i < 20; ++i) {
    Pose aside = Pose::Identity();
    aside.linear() =
        Eigen::AngleAxisd(0.1 * i, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    aside.translation() = Eigen::Vector3d(1.2 + 0.01 * i, 0.3, 0.2);
    const MeshDistance found = distance({sphere}, {sphere, aside}, {}, &work);
    EXPECT_EQ(found.distance, 0);
    EXPECT_EQ(find_triangle_pairs({sphere}, {sphere, aside}, {.limit = 1})[0], found.pair);
  }
  EXPECT_LT(work.filter_tests, 4000u) << "20,000 if a batch is filled before it is decided";
}

// Around two vertices that are nearest thirty-six pairs are as far apart: one of them is computed.
TEST(MeshDistance, OnePairAroundNearestVerticesIsComputed) {
  RandomSource source(102);
  const Mesh sphere = tests::make_sphere(1, 60, 60);
  Work work;
  for (int n = 0; n < 20; ++n) {
    Pose aside = random_pose(0, source);
    aside.translation() = 5 * source.vector(-1, 1).normalized();
    distance({sphere}, {sphere, aside}, {}, &work);
  }
  EXPECT_LT(work.triangle_tests, 700u) << "900 if all of them are computed";
}

Work work_of_soups_apart(double size, double offset) {
  RandomSource source(103);
  const Mesh soup = random_soup({.count = 500, .extent = 1, .size = size}, source);
  Work work;
  for (int n = 0; n < 20; ++n) {
    Pose aside = random_pose(0, source);
    aside.translation() = offset * source.vector(-1, 1).normalized();
    distance({soup}, {soup, aside}, {}, &work);
  }
  return work;
}

// Corners of large triangles say little of how near these are: their nearest points are the limit.
TEST(MeshDistance, NearestPointsOfLargeTrianglesAreALimit) {
  EXPECT_LT(work_of_soups_apart(1, 6).triangle_tests, 75u) << "100 with a limit by corners alone";
}

// Each leaf may bring the limit down, so that those behind it need not be looked at.
TEST(MeshDistance, NearerLeavesAreComparedFirst) {
  EXPECT_LT(work_of_soups_apart(0.2, 3.2).filter_tests, 3400u)
      << "3,800 if farther ones are compared first";
}

TEST(Law10MeshDistance, BadInputIsRefusedAndNamed) {
  const Mesh mesh = tests::make_sphere(1, 4, 4);
  Pose bad = Pose::Identity();
  bad.linear() *= 1.1;
  EXPECT_THROW(distance({mesh}, {mesh, bad}), PoseError);
  EXPECT_THROW(within({mesh, bad}, {mesh}, 1), PoseError);
  EXPECT_THROW(within({mesh}, {mesh}, -1), InputError);
  EXPECT_THROW(within({mesh}, {mesh}, std::numeric_limits<double>::quiet_NaN()), InputError);
  EXPECT_TRUE(within({mesh}, {mesh}, HUGE_VAL));
  try {
    within({mesh}, {mesh}, -1e-9);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "clearance: -1e-09 is not a distance");
  }
  try {
    distance({mesh}, {mesh}, {.hint = TrianglePair{0, 99}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find("hint: triangle 99 of mesh B"), 0u) << error.what();
  }
}

}  // namespace
}  // namespace graze
