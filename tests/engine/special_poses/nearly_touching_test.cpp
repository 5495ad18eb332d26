// Shapes that are apart by less than a search can tell, and have the distance that they have.

#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/narrowphase/triangle_distance.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

#include "tests/engine/special_poses/least_width.h"
#include "tests/engine/special_poses/pair_text.h"
#include "tests/engine/world/surface_distance.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::PlacedPair;

// Turned boxes that are apart by less than GJK can tell have the distance that they have.
TEST(NearlyTouching, BoxesThatAllButTouchHaveADistance) {
  RandomSource source(75);
  int apart = 0;
  for (int n = 0; n < 1000; ++n) {
    const double gap = std::pow(10.0, source.uniform(-15, -9));
    PlacedPair pair{Box{{1, 0.5, 0.75}}, Box{{0.25, 1, 0.5}}, tests::at(0, 0, 0),
                    tests::at({1.25 + gap, source.uniform(-1, 1), source.uniform(-1, 1)})};
    const Eigen::Matrix3d turn = tests::random_pose(1, source).linear();
    pair.pose_a.prerotate(turn);
    pair.pose_b.prerotate(turn);
    const ShapeDistance found = distance({pair.a, pair.pose_a}, {pair.b, pair.pose_b});
    EXPECT_EQ(found.status, PairStatus::Converged) << n;
    EXPECT_NEAR(found.distance, found.distance > 0 ? gap : 0, 4e-15) << n;
    if (found.distance > 0) {
      ++apart;
      EXPECT_GT(found.distance, 1e-300) << n;
    } else {
      EXPECT_LT(gap, 3e-13) << n;  // what the separating axis test says of its slack
    }
  }
  EXPECT_GT(apart, 500);
}

TEST(NearlyTouching, BallsThatAllButTouchHaveADistance) {
  for (const double gap : {0x1p-52, 0x1p-50, 0x1p-45, 0x1p-40}) {
    const PlacedPair balls{Sphere{{0, 0, 0}, 0.5}, Sphere{{0, 0, 0}, 1}, tests::at(0, 0, 0),
                           tests::at(1.5 + gap, 0, 0)};
    EXPECT_EQ(distance({balls.a, balls.pose_a}, {balls.b, balls.pose_b}).distance, gap);
    const PlacedPair box{Sphere{{0, 0, 0}, 0.5}, Box{{1, 1, 1}}, tests::at(0, 0, 0),
                         tests::at(1.5 + gap, 0.25, 0)};
    EXPECT_EQ(distance({box.a, box.pose_a}, {box.b, box.pose_b}).distance, gap);
  }
}

// The search for the distance of a ball and a triangle ended open at one in five hundred of these,
// and knew of one in four no more than that the two are apart.
TEST(NearlyTouching, BallsThatAllButTouchAMeshHaveADistance) {
  RandomSource source(80);
  int apart = 0;
  for (int n = 0; n < 3000; ++n) {
    const Vector3d a = source.vector(-1, 1), b = source.vector(-1, 1);
    const double flat = n % 3 == 0 ? std::pow(10.0, source.uniform(-12, 0)) : 1;
    const Vector3d c = a + (b - a) * source.uniform(0, 1) + source.vector(-1, 1) * flat;
    const double radius = std::pow(10.0, source.uniform(-6, 4));
    const double w[3] = {source.uniform(0, 1), n % 4 < 2 ? source.uniform(0, 1) : 0,
                         n % 4 < 1 ? source.uniform(0, 1) : 0};
    const Vector3d foot = (w[0] * a + w[1] * b + w[2] * c) / (w[0] + w[1] + w[2]);
    const double gap = radius * std::pow(10.0, source.uniform(-17, -1));
    const Vector3d away = n % 4 < 1 ? (b - a).cross(c - a).normalized() : source.vector(-1, 1);
    const Vector3d centre = foot + away.normalized() * (radius + gap);
    const Shape ball = Sphere{centre, radius};
    const Mesh mesh(std::vector{a, b, c}, std::vector<TriangleIndices>{{0, 1, 2}});
    const ShapeDistance found = distance({ball}, {mesh});
    const double beyond = distance(Triangle{centre, centre, centre}, {a, b, c}).distance - radius;
    ASSERT_EQ(found.distance > 0, !intersects({ball}, {mesh})) << n;
    EXPECT_EQ(found.status, PairStatus::Converged) << n;
    if (found.distance == 0) continue;
    ++apart;
    // A foot far along an edge is rounded as the edge is long, however near the ball is.
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const double ulps = 0x8p-52 * ((centre - a).norm() + radius) + 0x1p-53 * longest;
    EXPECT_NEAR(found.distance, beyond, ulps) << n;
    EXPECT_LE(found.lower_bound, found.distance) << n;
    EXPECT_GE(found.lower_bound, beyond - ulps - 0x1p-20 * beyond) << n;
  }
  EXPECT_GT(apart, 1000);
  const Mesh floor(std::vector<Vector3d>{{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}},
                   std::vector<TriangleIndices>{{0, 1, 2}});
  for (const double gap : {0x1p-52, 0x1p-50, 0x1p-45, 0x1p-40}) {
    const ShapeDistance found = distance({Sphere{{0, 0, 1 + gap}, 1}}, {floor});
    EXPECT_NEAR(found.distance, gap, 0x1p-40 * gap);
    EXPECT_NEAR(found.lower_bound, gap, 0x1p-30 * gap);
  }
}

// Where faces lie in each other but for rounding, which corners are inside is rounding, too: some
// were offered that stood beside the other mesh.
TEST(NearlyTouching, FlushFacesOfMeshesMeetWhereBothAre) {
  std::istringstream text(
      "mesh 0.25 0.5 1\n"
      "at 0.9332013593952806 0.10179052909102781 -0.3446359107959715 0 -0.001687463285173177 "
      "0.9602739138246276 0.27905405013293183 0 0.35934993431258816 -0.2598320584825904 "
      "0.8963006895535885 0\n"
      "mesh 0.5 0.5 1\n"
      "at 0.9332013593952806 0.10179052909102781 -0.3446359107959715 0 -0.001687463285173177 "
      "0.9602739138246276 0.27905405013293183 0 0.35934993431258816 -0.2598320584825904 "
      "0.8963006895535885 0\n"
      "mesh 1 1 1\n"
      "at 1 0 0 0 0 1 0 0 0 0 1 0\n"
      "mesh 1 1 1\n"
      "at 5.528326378428897e-14 1 -3.967534927697555e-14 0.17320508075688773 3.31919488507279e-14 "
      "3.967534927697555e-14 1 0 1 -5.528326378428897e-14 -3.31919488507279e-14 0\n");
  int shallow = 0;
  while (const std::optional<PlacedPair> pair = tests::read_pair(text)) {
    const tests::Surface of_a(pair->a), of_b(pair->b);
    for (const ShapeContact& contact :
         find_contacts({pair->a, pair->pose_a}, {pair->b, pair->pose_b})) {
      if (contact.depth > 1e-9) continue;
      ++shallow;
      EXPECT_LT(of_a.distance(pair->pose_a, contact.point_a), 1e-9);
      EXPECT_LT(of_b.distance(pair->pose_b, contact.point_b), 1e-9);
    }
  }
  EXPECT_GT(shallow, 1);
}

}  // namespace
}  // namespace graze
