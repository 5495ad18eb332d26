// Contacts with a margin: each point on its own surface, however faces lean and however far the two
// are apart, and each depth what lies between its points along the normal.

#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

#include "tests/engine/special_poses/pair_text.h"
#include "tests/engine/special_poses/special_pairs.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/engine/world/surface_distance.h"
#include "tests/shapes/random_meshes.h"
#include "tests/shapes/shape_kinds.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::PlacedPair;
using tests::Surface;

// What manifold.h promises, and the rounding of what is measured here.
constexpr double kContactPoints = 0x1p-32;
constexpr double kRounding = 1e-14;
constexpr double kMostAside = 0x1p-16;
constexpr double kDepthTolerance = 1e-6;

struct MarginCounts {
  int near = 0;      ///< pairs that are apart and have contacts
  int touching = 0;  ///< pairs that touch
  int contacts = 0;
  double worst_point = 0;  ///< off its surface, in units of what is promised
};

bool has(const PlacedPair& pair, ShapeKind kind) {
  return pair.a.kind() == kind || pair.b.kind() == kind;
}

std::string of(const char* text, double share) {
  return (std::ostringstream() << text << " by " << share << " of the scale").str();
}

/// The first promise about the contacts within a margin that is broken; empty if all are kept.
std::string broken_margin_law(const PlacedPair& pair, double margin, MarginCounts& counts) {
  Work work;
  const ShapeDistance gap = distance({pair.a, pair.pose_a}, {pair.b, pair.pose_b}, &work);
  const Manifold found =
      find_contacts({pair.a, pair.pose_a}, {pair.b, pair.pose_b}, {.margin = margin}, &work);
  const bool is_open = gap.status == PairStatus::NotConverged;
  if (found.empty() != ((is_open ? gap.lower_bound : gap.distance) > margin))
    return "contacts of what is farther than the margin, or none of what is not";
  if (found.empty() || is_open || work.convex_failures > 0) return {};
  ++(gap.distance > 0 ? counts.near : counts.touching);
  const Surface of_a(pair.a), of_b(pair.b);
  const double scale = scale_of(pair);
  const double rounding =
      kRounding * (pair.pose_a.translation().norm() + pair.pose_b.translation().norm() + scale);
  const double most = kContactPoints * scale + rounding;
  for (const ShapeContact& contact : found) {
    ++counts.contacts;
    const double off = std::max(of_a.distance(pair.pose_a, contact.point_a),
                                of_b.distance(pair.pose_b, contact.point_b));
    counts.worst_point = std::max(counts.worst_point, off / most);
    if (!(off <= most)) return of("beside a surface", off / scale);
    if (!(contact.depth >= -margin)) return "farther than the margin";
    if (gap.distance > 0 && !(contact.depth <= 0)) return "deep, though apart";
    const Vector3d way = contact.point_a - contact.point_b;
    const double aside = (way - contact.depth * contact.normal).norm();
    const bool is_proved = work.penetration_failures == 0;
    const bool leads_there =
        has(pair, ShapeKind::HalfSpace) || (is_proved && !has(pair, ShapeKind::Mesh));
    const double least_known = has(pair, ShapeKind::Box) ? std::abs(contact.depth) / 19 : 0;
    if (leads_there && !(aside <= kMostAside * scale + least_known + rounding))
      return of("beside its way", aside / scale);
    const double wrong = std::abs(way.dot(contact.normal) - contact.depth);
    const double known = kDepthTolerance * (smaller_size(pair) + margin) + most;
    if (is_proved && !(wrong <= known + least_known))
      return of("of a depth that is not that of its points", wrong / scale);
  }
  return {};
}

/// Of the distance or a bit less, as of the shapes' sizes, or all of what there is.
double drawn_margin(const PlacedPair& pair, RandomSource& source) {
  const double apart = distance({pair.a, pair.pose_a}, {pair.b, pair.pose_b}).distance;
  const int way = source.integer(0, 5);
  switch (way) {
    case 0:
      return apart;
    case 1:
      return 0.99 * apart;
    case 2:
      return 2 * apart;
    case 3:
      return 8 * scale_of(pair);
    default:
      return smaller_size(pair) * std::pow(10.0, source.uniform(-4, 0));
  }
}

/// Turned by up to a quarter of a radian from one of the right turns, so that faces that are near
/// each other lean, and apart by less than their sizes or in each other.
PlacedPair leaning_pair(std::size_t n, RandomSource& source) {
  const std::size_t kinds = tests::kOwnKinds.size();
  PlacedPair pair{tests::plain_shape(tests::kOwnKinds[n % tests::kConvexKinds], n),
                  tests::plain_shape(tests::kOwnKinds[n / 7 % kinds], n / 49), Pose::Identity(),
                  Pose::Identity()};
  const Eigen::AngleAxisd lean{std::pow(10.0, source.uniform(-6, -0.6)),
                               source.vector(-1, 1).normalized()};
  pair.pose_b.linear() = lean * tests::right_turn(static_cast<std::size_t>(source.integer(0, 23)));
  const Vector3d out = has(pair, ShapeKind::HalfSpace)
                           ? Vector3d(-pair.pose_b.linear().col(2))
                           : Vector3d(source.vector(-1, 1).normalized());
  const double gap = smaller_size(pair) * source.uniform(-0.4, 0.7);
  pair.pose_b.translation() = out * (width_along(pair, out) + gap);
  return pair;
}

TEST(SpecialPoses, ContactsWithAMarginStandOnBothSurfaces) {
  MarginCounts counts;
  RandomSource source(101);
  for (int n = 0; n < 6000; ++n) {
    const PlacedPair pair = tests::drawn_pair(source, tests::kOwnKinds.size());
    if (pair.a.kind() == ShapeKind::Mesh && pair.b.kind() == ShapeKind::Mesh) continue;
    const double margin = drawn_margin(pair, source);
    ASSERT_EQ(broken_margin_law(pair, margin, counts), "") << margin << "\n" << text_of(pair);
  }
  EXPECT_GT(counts.near, 500);
  EXPECT_GT(counts.touching, 1500);
}

// A face that leans by an angle was once grown along its own normal and taken back along the
// contact's: so its points were beside it by the margin times that angle.
TEST(SpecialPoses, ContactsWithAMarginStandOnFacesThatLean) {
  MarginCounts counts;
  RandomSource source(102);
  for (std::size_t n = 0; n < 12000; ++n) {
    const PlacedPair pair = leaning_pair(n, source);
    const double margin = drawn_margin(pair, source);
    ASSERT_EQ(broken_margin_law(pair, margin, counts), "") << margin << "\n" << text_of(pair);
  }
  EXPECT_GT(counts.near, 2000);
  EXPECT_GT(counts.touching, 1000);
  EXPECT_GT(counts.contacts, 9000);
}

}  // namespace
}  // namespace graze
