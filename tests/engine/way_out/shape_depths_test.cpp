// Law 15 of shapes, and of shapes on meshes: moved along its way out by a thousandth more than a
// region's greatest depth the two are apart, by a twentieth less they are not. Whether moved bodies
// meet is the truth. And what lies and trembles has the same contacts from step to step.

#include <graze/engine/world/manifold.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "tests/engine/way_out/tessellated.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kThousandth = 1.001;
// Which way is the shortest is known to 1e-6 of the smaller size, over edges to 1e-7, and whether
// two meet to 2^-34 of the scale.
constexpr double kWay = 1e-6, kEdgeWay = 1.2e-7, kMeeting = 0x1p-33, kRounding = 2e-9;

enum class PartedKind { Box, Cylinder, Cone, Capsule, Drum };
constexpr std::array kPartedKinds = {PartedKind::Box, PartedKind::Cylinder, PartedKind::Cone,
                                     PartedKind::Capsule, PartedKind::Drum};

/// A prism of so many corners as the hull of its corners.
ConvexHull upright_prism(const Vector3d& half, int sides) {
  std::vector<Vector3d> points;
  points.reserve(2 * static_cast<std::size_t>(sides));
  for (int i = 0; i < sides; ++i) {
    const double turn = 2 * std::numbers::pi * i / sides;
    for (const double z : {-half.z(), half.z()})
      points.emplace_back(std::cos(turn) * half.x(), std::sin(turn) * half.y(), z);
  }
  return ConvexHull(points);
}

Shape of_kind(PartedKind kind, const Vector3d& half, RandomSource& source) {
  switch (kind) {
    case PartedKind::Box:
      return Box{half};
    case PartedKind::Cylinder:
      return Cylinder{half.x(), half.z()};
    case PartedKind::Cone:
      return Cone{half.x(), half.z()};
    case PartedKind::Capsule:
      return Capsule{0.4 * half.x(), half.z()};
    default:
      return upright_prism(half, static_cast<int>(source.integer(4, 16)));
  }
}

Vector3d half_sizes(RandomSource& source) {
  const double x = source.uniform(0.1, 1), y = source.uniform(0.1, 1);
  return {x, y, source.uniform(0.05, 1)};
}

/// Upright, upside down, on a side, on an edge, or anyhow.
Matrix3d special_turn(RandomSource& source) {
  constexpr double kRight = std::numbers::pi / 2;
  const Vector3d across = source.integer(0, 1) == 0 ? Vector3d::UnitX() : Vector3d::UnitY();
  switch (static_cast<int>(source.integer(0, 4))) {
    case 0:
      return Matrix3d::Identity();
    case 1:
      return AngleAxisd(2 * kRight, across).toRotationMatrix();
    case 2:
      return AngleAxisd(kRight, across).toRotationMatrix();
    case 3:
      return AngleAxisd(kRight / 2, across).toRotationMatrix();
    default:
      return AngleAxisd{source.uniform(-3, 3), source.vector(-1, 1).normalized()}
          .toRotationMatrix();
  }
}

struct ShapePair {
  Shape lower, upper;
  Pose of_lower = Pose::Identity(), of_upper = Pose::Identity();
  double size = 0;  ///< of both, metres
};

/// Leans the upper one, from next to nothing on, and sinks it into the lower one.
void lay_on(ShapePair& pair, const Vector3d& halves, RandomSource& source) {
  const double lean = source.integer(0, 4) == 0 ? 0 : std::pow(10, source.uniform(-9, -2));
  const double about = source.uniform(-3, 3) * (source.integer(0, 3) == 0 ? 1e-4 : 1);
  const Vector3d axis = Vector3d{source.uniform(-1, 1), source.uniform(-1, 1), 0}.normalized();
  const Vector3d up = Vector3d::UnitZ();
  pair.of_upper.linear() =
      AngleAxisd(lean, axis).toRotationMatrix() * AngleAxisd(about, up) * pair.of_upper.linear();
  const double spread = source.integer(0, 4) == 0 ? 0 : 0.5;
  const double depth = std::pow(10, source.uniform(-8, -1.5));
  pair.of_upper.translation() = Vector3d{source.uniform(-spread, spread) * halves.x(),
                                         source.uniform(-spread, spread) * halves.y(), 0};
  pair.of_upper.translation().z() = tests::reach_of(pair.lower, pair.of_lower, up) +
                                    tests::reach_of(pair.upper, pair.of_upper, -up) - depth;
  pair.size = halves.norm() + pair.of_upper.translation().norm();
}

bool meet_moved(const ShapePair& pair, const Vector3d& way) {
  Pose moved = pair.of_lower;
  moved.translation() -= way;
  return intersects({pair.lower, moved}, {pair.upper, pair.of_upper});
}

double deepest_of(const Manifold& found) {
  double depth = 0;
  for (const ShapeContact& contact : found)
    depth = std::max(depth, contact.depth);
  return depth;
}

/// False if the pair has not one region whose way is proved to be the shortest.
bool expect_way_out(const ShapePair& pair, double tolerance) {
  Work work;
  const Manifold found =
      find_contacts({pair.lower, pair.of_lower}, {pair.upper, pair.of_upper}, &work);
  if (found.region_count() != 1 || work.penetration_failures > 0) return false;
  const double depth = deepest_of(found);
  const Vector3d& normal = found[0].normal;
  const double meeting = kMeeting * pair.size;
  const double needs = kThousandth * depth + tolerance + meeting;
  EXPECT_FALSE(meet_moved(pair, normal * needs)) << depth;
  const double short_of_it = 0.95 * depth - kWay * pair.size - meeting;
  EXPECT_TRUE(short_of_it < 0 || meet_moved(pair, normal * short_of_it)) << depth;
  return true;
}

TEST(WayOut, Law15MovedByTheGreatestDepthShapesPart) {
  RandomSource source(15);
  for (const PartedKind of_lower : kPartedKinds) {
    for (const PartedKind of_upper : kPartedKinds) {
      SCOPED_TRACE(testing::Message() << int(of_lower) << " under " << int(of_upper));
      const auto is_round = [](PartedKind kind) {
        return kind == PartedKind::Cylinder || kind == PartedKind::Cone;
      };
      const bool is_any_round = is_round(of_lower) || is_round(of_upper);
      int regions = 0;
      for (int n = 0; n < 600; ++n) {
        SCOPED_TRACE(n);
        const Vector3d lower = half_sizes(source), upper = half_sizes(source);
        ShapePair pair{of_kind(of_lower, lower, source), of_kind(of_upper, upper, source)};
        const bool is_upright = n % 2 == 0;
        if (!is_upright) pair.of_lower.linear() = special_turn(source);
        if (!is_upright) pair.of_upper.linear() = special_turn(source);
        lay_on(pair, lower + upper, source);
        // Of sides that are lines, and where a round end leaves the rim of the other, the depth is
        // known as well as the way; of flat ends to rounding.
        const double rounding = is_upright && !is_any_round ? kRounding : kWay * pair.size;
        regions += expect_way_out(pair, rounding) ? 1 : 0;
        if (HasFailure()) return;
      }
      EXPECT_GT(regions, 50);
    }
  }
}

TEST(WayOut, Law15MovedByTheGreatestDepthShapesThatLieOnMeshesPart) {
  RandomSource source(16);
  int regions = 0;
  for (int n = 0; n < 4000; ++n) {
    SCOPED_TRACE(n);
    const Vector3d lower = half_sizes(source), upper = half_sizes(source);
    const auto of_upper = n % 2 == 0 ? PartedKind::Box : PartedKind::Drum;
    ShapePair pair{tests::tessellated_box(lower, 1 + n % 3), of_kind(of_upper, upper, source)};
    lay_on(pair, lower + upper, source);
    regions += expect_way_out(pair, kEdgeWay * pair.size) ? 1 : 0;
    if (HasFailure()) return;
  }
  EXPECT_GT(regions, 2000);
}

std::set<ContactFeature> features_of(const Manifold& found) {
  std::set<ContactFeature> features;
  for (const ShapeContact& contact : found)
    features.insert(contact.feature);
  return features;
}

// The order in which triangles of one plane were left changed with each rounding, and so did the
// names of corners that two of them share; an edge that was shorter by a hair than the face beside
// it made a second region; and the deepest of many corners took the place of one next to it.
TEST(WayOut, Law15WhatLiesAndTremblesKeepsItsContacts) {
  RandomSource source(17);
  const Vector3d half(0.2, 0.2, 0.15);
  const std::vector<Shape> lower = {tests::tessellated_box(half, 1),
                                    tests::tessellated_box(half, 3), Box{half},
                                    upright_prism(half, 12), Cylinder{0.2, 0.15}};
  const std::vector<Shape> upper = {Box{half}, upright_prism(half, 12), Cylinder{0.2, 0.15}};
  for (std::size_t s = 0; s < lower.size(); ++s) {
    for (std::size_t t = 0; t < upper.size(); ++t) {
      SCOPED_TRACE(testing::Message() << "lower " << s << ", upper " << t);
      std::set<ContactFeature> first;
      for (int step = 0; step < 200; ++step) {
        ShapePair pair{lower[s], upper[t]};
        const double about_x = 1e-5 * source.uniform(-1, 1);
        const double about_y = 1e-5 * source.uniform(-1, 1);
        pair.of_upper.linear() =
            (AngleAxisd(about_x, Vector3d::UnitX()) * AngleAxisd(about_y, Vector3d::UnitY()) *
             AngleAxisd(0.3, Vector3d::UnitZ()))
                .toRotationMatrix();
        pair.of_upper.translation() = Vector3d(0.003, 0.002, 0.2993) + 1e-6 * source.vector(-1, 1);
        const Manifold found =
            find_contacts({pair.lower, pair.of_lower}, {pair.upper, pair.of_upper});
        ASSERT_EQ(found.region_count(), 1u) << step;
        ASSERT_EQ(found.size(), 4u) << step;
        if (step == 0) first = features_of(found);
        ASSERT_EQ(features_of(found), first) << step;
      }
    }
  }
}

}  // namespace
}  // namespace graze
