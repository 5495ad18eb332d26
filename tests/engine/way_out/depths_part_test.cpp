// Law 15: moved along its way out by a region's greatest depth two meshes are apart, by less they
// are not. What lies flat on each other with the tiniest lean is the hard case: of the corners of
// its region four are left, and one has to be as deep as the deepest, to three thousandths. Whether
// moved bodies meet is the truth: by exact tests of triangles, and by the separating axes of boxes.

#include <graze/engine/world/manifold.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/way_out/tessellated.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

const Vector3d kTowardLower(0, 0, -1);

// What the way may lack: a share of it, and one of the size, which is about a metre.
constexpr double kLacking = 1.0031, kTolerance = 2e-9;

struct FlatPair {
  Shape lower, upper;
  Pose pose = Pose::Identity();  ///< of the upper one
};

double greatest_depth(const Manifold& found) {
  double depth = 0;
  for (const ShapeContact& contact : found)
    depth = std::max(depth, contact.depth);
  return depth;
}

/// Whether they meet once the lower one has taken so much of the way out.
bool meet_after(const FlatPair& pair, const Vector3d& normal, double way) {
  Pose moved = Pose::Identity();
  moved.translation() = -way * normal;
  return intersects({pair.lower, moved}, {pair.upper, pair.pose});
}

/// Turns the upper one about z, leans it, and sinks it into the upper side of the lower one, all
/// from next to nothing on.
void lay(FlatPair& pair, const Vector3d& lower, const Vector3d& upper, RandomSource& source) {
  const double lean = std::pow(10, source.uniform(-9, -2));
  const double depth = std::pow(10, source.uniform(-8, -3));
  const Vector3d axis = Vector3d{source.uniform(-1, 1), source.uniform(-1, 1), 0}.normalized();
  const double about = source.uniform(-3, 3) * (source.integer(0, 3) == 0 ? 1e-4 : 1);
  pair.pose.linear() =
      (AngleAxisd(lean, axis) * AngleAxisd(about, Vector3d::UnitZ())).toRotationMatrix();
  pair.pose.translation() = Vector3d{source.uniform(-0.7, 0.7) * (lower.x() + upper.x()),
                                     source.uniform(-0.7, 0.7) * (lower.y() + upper.y()), 0};
  pair.pose.translation().z() =
      lower.z() + tests::reach_of(pair.upper, pair.pose, kTowardLower) - depth;
}

Vector3d half_extents(RandomSource& source) {
  const double x = source.uniform(0.1, 1), y = source.uniform(0.1, 1);
  return {x, y, source.uniform(0.05, 1)};
}

Mesh prism(const Vector3d& half, int sides) {
  const std::vector<tests::ProfilePoint> profile = {
      {0, -half.z()}, {half.x(), -half.z()}, {half.x(), half.z()}, {0, half.z()}};
  return tests::turned_profile(profile, sides, {1, 1});
}

/// `boxes` are the same bodies, if they are boxes.
void expect_parted(const FlatPair& pair, const FlatPair* boxes, int& regions) {
  const Manifold found = find_contacts({pair.lower, Pose::Identity()}, {pair.upper, pair.pose});
  if (found.region_count() != 1) return;
  ++regions;
  const double depth = greatest_depth(found);
  const Vector3d& normal = found[0].normal;
  for (const FlatPair* each : {&pair, boxes}) {
    if (each == nullptr) continue;
    ASSERT_FALSE(meet_after(*each, normal, kLacking * depth + kTolerance)) << depth;
    ASSERT_TRUE(depth < kTolerance || meet_after(*each, normal, 0.95 * depth - kTolerance))
        << depth;
  }
}

TEST(WayOut, Law15MovedByTheGreatestDepthFlatMeshesPart) {
  RandomSource source(5);
  int boxes = 0, prisms = 0;
  for (int n = 0; n < 6000; ++n) {
    SCOPED_TRACE(n);
    const Vector3d lower = half_extents(source), upper = half_extents(source);
    if (n % 2 == 0) {
      FlatPair pair{tests::tessellated_box(lower, 1 + n % 3),
                    tests::tessellated_box(upper, 1 + n / 3 % 3)};
      lay(pair, lower, upper, source);
      const FlatPair analytic{Box{lower}, Box{upper}, pair.pose};
      expect_parted(pair, &analytic, boxes);
    } else {
      FlatPair pair{prism(lower, 5 + n % 7), prism(upper, 5 + n % 11)};
      lay(pair, lower, upper, source);
      expect_parted(pair, nullptr, prisms);
    }
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(boxes, 1800);
  EXPECT_GT(prisms, 1800);
}

// The deepest of five corners was given away, as all are the same to a hundred-thousandth of the
// width: a ninth of the depth. And what of the one lies beside the other counted for the depth.
TEST(WayOut, Law15TheDeepestOfFiveCornersIsAContact) {
  const Vector3d lower(0.69935855184374163, 0.32528378201589286, 0.947020473426613);
  const Vector3d upper(0.79428143674967056, 0.68968691349511124, 0.25436171184263051);
  FlatPair boxes{Box{lower}, Box{upper}};
  boxes.pose.linear() << 0.8152146210072162, 0.57915897791198434, -7.9325388364405361e-08,
      -0.57915897791198456, 0.81521462100721975, 2.2253076763307825e-08, 7.7555285605373518e-08,
      2.7800977307755764e-08, 0.99999999999999656;
  boxes.pose.translation() << 0.12384007188240308, -0.20317222350050762, 1.2013821852692435;
  for (const int cells : {1, 2, 3, 4}) {
    SCOPED_TRACE(cells);
    const FlatPair pair{tests::tessellated_box(lower, cells), tests::tessellated_box(upper, 1),
                        boxes.pose};
    int regions = 0;
    expect_parted(pair, &boxes, regions);
    EXPECT_EQ(regions, 1);
    const Manifold found = find_contacts({pair.lower, Pose::Identity()}, {pair.upper, pair.pose});
    // Where a side of the upper one passes over an edge of the lower one, by the planes of both. An
    // end of a crossing lies off the planes by rounding, which is more where the faces are divided.
    EXPECT_NEAR(greatest_depth(found), 7.00341938e-08, 5e-10);
  }
}

}  // namespace
}  // namespace graze
