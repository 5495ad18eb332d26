#include <graze/bvh/error.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/separating_translation.h>
#include <graze/engine/pose_text.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "tests/shapes/closed_meshes.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

Pose shifted(double x, double y, double z) {
  Pose pose = Pose::Identity();
  pose.translation() << x, y, z;
  return pose;
}

/// B moved along a unit vector as the library moves it.
Pose moved(Pose pose, const Eigen::Vector3d& direction, double distance) {
  for (int k = 0; k < 3; ++k) {
    const double step = distance * direction[k];
    pose.translation()[k] += step;
  }
  return pose;
}

/// Whether the meshes meet at the distance, or at one up to twice as far and one more.
bool meet_from(const PlacedMesh& a, const PlacedMesh& b, const Eigen::Vector3d& direction,
               double distance, double reach) {
  for (int i = 0; i <= 40; ++i) {
    const double s = distance + i * (reach / 40);
    if (intersects(a, {b.mesh, moved(b.pose, direction, s)})) return true;
  }
  return false;
}

SeparatingTranslation expect_apart(const PlacedMesh& a, const PlacedMesh& b,
                                   const Eigen::Vector3d& direction, double reach) {
  const SeparatingTranslation separation = separating_translation(a, b, direction);
  EXPECT_GE(separation.distance, 0);
  EXPECT_FALSE(intersects(a, {b.mesh, separation.pose_b}));
  EXPECT_FALSE(meet_from(a, b, separation.direction, separation.distance, reach));
  const Pose expected = moved(b.pose, separation.direction, separation.distance);
  EXPECT_EQ(separation.pose_b.matrix(), expected.matrix());
  return separation;
}

TEST(SeparatingTranslation, BoxesLeaveByWhatTheyOverlap) {
  const Mesh box = tests::make_box({1, 1, 1});
  const Pose pose = shifted(0.5, 0.25, 1.75);
  const auto distance = [&](double x, double y, double z) {
    return expect_apart({box}, {box, pose}, {x, y, z}, 4).distance;
  };
  EXPECT_NEAR(distance(0, 0, 1), 0.25, 1e-13);
  EXPECT_NEAR(distance(0, 0, -7), 3.75, 1e-13);
  EXPECT_NEAR(distance(1, 0, 0), 1.5, 1e-13);
  EXPECT_NEAR(distance(0, 1e-200, 0), 1.75, 1e-13);
  EXPECT_NEAR(distance(0, 3e200, 4e200), 0.25 / 0.8, 1e-13);
  EXPECT_GT(distance(0, 0, 1), 0.25) << "touching is not apart";
}

TEST(SeparatingTranslation, ABoxThatSlidesAlongAnotherIsLedPastIt) {
  const Mesh box = tests::make_box({1, 1, 1});
  EXPECT_NEAR(expect_apart({box}, {box, shifted(0, 0, 2)}, {1, 0, 0}, 4).distance, 2, 1e-13);
  EXPECT_NEAR(expect_apart({box}, {box, shifted(0, 2, 2)}, {-1, 0, 0}, 4).distance, 2, 1e-13);
  EXPECT_NEAR(expect_apart({box}, {box, shifted(-2, 2, 2)}, {0, 0, 1}, 4).distance, 0, 1e-13);
  // Apart by more than rounding: never.
  EXPECT_EQ(expect_apart({box}, {box, shifted(0, 0, 2 + 1e-13)}, {1, 0, 0}, 4).distance, 0);
}

TEST(SeparatingTranslation, TheLastContactCountsNotTheFirstGap) {
  const Mesh box = tests::make_box({0.25, 0.25, 0.25});
  const Mesh torus = tests::make_torus(2, 0.5, 48, 24);
  // From the tube through the hole to the other side of the ring.
  const SeparatingTranslation through =
      expect_apart({torus}, {box, shifted(2, 0, 0)}, {-1, 0, 0}, 2);
  EXPECT_NEAR(through.distance, 2 + 2.5 + 0.25, 1e-12);
  EXPECT_FALSE(intersects({torus}, {box, shifted(0, 0, 0)}));
  // It starts in the hole and meets nothing upwards, and the ring sideways.
  EXPECT_EQ(expect_apart({torus}, {box}, {0, 0, 1}, 5).distance, 0);
  EXPECT_NEAR(expect_apart({torus}, {box}, {1, 0, 0}, 5).distance, 2.75, 1e-12);
}

TEST(SeparatingTranslation, AMeshInsideAnotherIsLedOut) {
  const Mesh outer = tests::make_box({2, 2, 2});
  const Mesh inner = tests::make_box({1, 1, 1});
  ASSERT_FALSE(intersects({outer}, {inner}));
  EXPECT_NEAR(expect_apart({outer}, {inner}, {0, 1, 0}, 4).distance, 3, 1e-13);
}

TEST(SeparatingTranslation, SpheresLeaveByTheSumOfTheirRadii) {
  const Mesh sphere = tests::make_sphere(1, 31, 64);  // with a vertex on each axis
  EXPECT_NEAR(expect_apart({sphere}, {sphere, shifted(0, 0, 0.5)}, {0, 0, 1}, 2).distance, 1.5,
              1e-13);
  EXPECT_NEAR(expect_apart({sphere}, {sphere, shifted(0.5, 0, 0)}, {-1, 0, 0}, 2).distance, 2.5,
              1e-13);
}

/// Law 1: distances are no shorter than what the triangles, taken one by one, need, and scaling by
/// a power of two scales them bit for bit.
TEST(Law8Separation, PowersOfTwoScaleIt) {
  RandomSource source(3);
  for (int n = 0; n < 20; ++n) {
    const Mesh a = tests::random_soup({.count = 20}, source);
    const Mesh b = tests::random_soup({.count = 20}, source);
    const Eigen::Vector3d direction = source.vector(-1, 1);
    const double plain = separating_translation({a}, {b}, direction).distance;
    for (const double scale : {0x1p-500, 0x1p-30, 0x1p500}) {
      const Mesh scaled_a = tests::mapped(a, scale, {0, 0, 0});
      const Mesh scaled_b = tests::mapped(b, scale, {0, 0, 0});
      EXPECT_EQ(separating_translation({scaled_a}, {scaled_b}, direction).distance, plain * scale);
    }
  }
}

double brute_force(const Mesh& a, const Mesh& b, const Eigen::Vector3d& direction) {
  double longest = 0;
  const std::vector<TriangleIndices> first = {{0, 1, 2}};
  for (std::size_t i = 0; i < a.triangles().size(); ++i) {
    const Triangle s = a.triangle(i);
    const std::vector<Eigen::Vector3d> points_a = {s.a, s.b, s.c};
    for (std::size_t j = 0; j < b.triangles().size(); ++j) {
      const Triangle t = b.triangle(j);
      const std::vector<Eigen::Vector3d> points_b = {t.a, t.b, t.c};
      const Mesh one(points_a, first);
      const Mesh other(points_b, first);
      longest = std::max(longest, separating_translation({one}, {other}, direction).distance);
    }
  }
  return longest;
}

/// Law 9, and that shorter will not do.
TEST(Law9Separation, SoupsAgreeWithBruteForce) {
  RandomSource source(1);
  int positive = 0;
  for (int n = 0; n < 60; ++n) {
    const Mesh a =
        n % 3 == 0 ? tests::lattice_soup(12, 2, source) : tests::random_soup({.count = 16}, source);
    const Mesh b =
        n % 3 == 0 ? tests::lattice_soup(12, 2, source) : tests::random_soup({.count = 16}, source);
    const Eigen::Vector3d direction =
        n % 2 == 0 ? source.vector(-1, 1) : source.lattice_point(-1, 1) + Eigen::Vector3d(0, 0, 3);
    const SeparatingTranslation separation = expect_apart({a}, {b}, direction, 4);
    EXPECT_NEAR(separation.distance, brute_force(a, b, direction), 1e-12);
    positive += separation.distance > 0;
    // Where the motion slides along a surface, the exact last contact may be earlier.
    if (n % 3 == 0 || separation.distance == 0) continue;
    EXPECT_TRUE(meet_from({a}, {b}, separation.direction, separation.distance * (1 - 1e-9), 0))
        << n;
  }
  EXPECT_GT(positive, 40);
}

TEST(SeparatingTranslation, HugeOffsets) {
  const Mesh box = tests::make_box({1, 1, 1});
  const double far = 1e9;
  const SeparatingTranslation separation =
      expect_apart({box, shifted(far, far, far)}, {box, shifted(far, far, far + 1)}, {0, 0, 1}, 4);
  EXPECT_NEAR(separation.distance, 1, 1e-4);
}

TEST(SeparatingTranslation, DegenerateTriangles) {
  const std::vector<Eigen::Vector3d> points = {{0, 0, 0}, {1, 0, 0}, {0.5, 0, 3}, {0.25, 0, 0}};
  const auto mesh_of = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    const std::vector<TriangleIndices> triangles = {{i, j, k}};
    return Mesh(points, triangles);
  };
  const Mesh point = mesh_of(0, 0, 0);
  const Mesh segment = mesh_of(0, 3, 1);
  const Mesh triangle = mesh_of(0, 1, 2);
  EXPECT_NEAR(expect_apart({point}, {point}, {1, 0, 0}, 1).distance, 0, 1e-13);
  EXPECT_NEAR(expect_apart({segment}, {point}, {1, 0, 0}, 1).distance, 1, 1e-13);
  EXPECT_NEAR(expect_apart({triangle}, {segment}, {0, 0, 1}, 4).distance, 3, 1e-13);
  EXPECT_NEAR(expect_apart({triangle}, {point, shifted(0.5, 0, -1)}, {0, 0, 1}, 4).distance, 4,
              1e-13);
  EXPECT_EQ(expect_apart({triangle}, {point, shifted(0.5, 1, 0)}, {0, 0, 1}, 4).distance, 0);
  EXPECT_NEAR(expect_apart({segment}, {segment, shifted(0.5, 0, 0)}, {-1, 0, 0}, 4).distance, 1.5,
              1e-13);
  EXPECT_EQ(expect_apart({segment}, {segment, shifted(0, 0, 1)}, {1, 0, 0}, 4).distance, 0);
}

class SeparationOfParts : public testing::TestWithParam<const char*> {};

TEST_P(SeparationOfParts, EndsTheLastContact) {
  const std::string folder = GRAZE_DATA_DIR;
  const std::string name = GetParam();
  const std::string file = name.substr(0, name.find('.'));
  const auto load = [&](const std::string& part) {
    const char* ending = part == "bolt" ? ".obj" : part == "nut" ? ".stl" : ".ply";
    return load_mesh(folder + "/meshes/" + part + ending);
  };
  const Mesh a = load(file.substr(0, file.find('-')));
  const Mesh b = load(file.substr(file.find('-') + 1));
  const std::vector<Pose> poses = load_poses(folder + "/poses/" + name + ".txt");
  RandomSource source(7);
  const double size = (b.bounds().max - b.bounds().min).norm();
  for (std::size_t i = 0; i < poses.size(); i += 7) {
    const Eigen::Vector3d direction = source.vector(-1, 1);
    const SeparatingTranslation separation = expect_apart({a}, {b, poses[i]}, direction, size);
    EXPECT_GT(separation.distance, 0);
    EXPECT_TRUE(
        meet_from({a}, {b, poses[i]}, separation.direction, separation.distance * (1 - 1e-9), 0))
        << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Bundled, SeparationOfParts,
                         testing::Values("rock-rock.touch", "rock-rock.deep", "link-link.touch",
                                         "link-link.deep", "bolt-nut.touch", "bolt-nut.deep"));

TEST(SeparatingTranslation, WithoutADirectionItIsNoLongerThanAlongAnAxis) {
  const Mesh box = tests::make_box({1, 1, 1});
  const PlacedMesh a{box};
  const PlacedMesh b{box, shifted(0.5, 0.25, -1.75)};
  const SeparatingTranslation best = separating_translation(a, b);
  EXPECT_FALSE(intersects(a, {box, best.pose_b}));
  EXPECT_EQ(best.direction, Eigen::Vector3d(0, 0, -1));
  EXPECT_NEAR(best.distance, 0.25, 1e-13);
  const SeparatingTranslation none = separating_translation(a, {box, shifted(5, 0, 0)});
  EXPECT_EQ(none.distance, 0);
  EXPECT_EQ(none.translation, Eigen::Vector3d(0, 0, 0));
  const Mesh inner = tests::make_box({0.5, 0.5, 0.5});
  EXPECT_EQ(separating_translation(a, {inner}).distance, 0) << "surfaces only";
  RandomSource source(9);
  for (int n = 0; n < 20; ++n) {
    const Mesh s = tests::random_soup({.count = 20}, source);
    const Mesh t = tests::random_soup({.count = 20}, source);
    const SeparatingTranslation shortest = separating_translation({s}, {t});
    EXPECT_FALSE(intersects({s}, {t, shortest.pose_b}));
    if (!intersects({s}, {t})) continue;
    for (const Eigen::Vector3d& axis : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, -1, 0)})
      EXPECT_LE(shortest.distance, separating_translation({s}, {t}, axis).distance);
  }
}

TEST(Law10Separation, BadInputIsRefused) {
  const Mesh box = tests::make_box({1, 1, 1});
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(separating_translation({box}, {box}, {0, 0, 0}), InputError);
  EXPECT_THROW(separating_translation({box}, {box}, {0, nan, 0}), InputError);
  EXPECT_THROW(separating_translation({box}, {box}, {infinity, 0, 0}), InputError);
  EXPECT_THROW(separating_translation({box, shifted(nan, 0, 0)}, {box}, {1, 0, 0}), PoseError);
  const Mesh huge = tests::make_box({1e308, 1, 1});
  EXPECT_THROW(separating_translation({huge}, {huge}, {1, 0, 0}), PoseError);
}

TEST(SeparatingTranslation, WorkIsCounted) {
  const Mesh sphere = tests::make_sphere(1, 40, 40);
  Work work;
  separating_translation({sphere}, {sphere, shifted(0.3, 0, 0)}, {1, 2, 3}, &work);
  EXPECT_GT(work.volume_rejections, 0u);
  EXPECT_GT(work.triangle_tests, 0u);
  EXPECT_LT(work.triangle_tests, sphere.triangles().size() * sphere.triangles().size() / 100);
}

}  // namespace
}  // namespace graze
