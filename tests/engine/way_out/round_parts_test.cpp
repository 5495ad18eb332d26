// Law 15 where round parts meet: what hardly moves keeps the depths of its contacts, and moved by
// the greatest depth the two are apart.

#include <graze/engine/world/convex_hull.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "tests/engine/way_out/tessellated.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

enum class RoundPart { Box, Prism, Cylinder, Cone, Capsule };

Shape body_of(RoundPart kind, RandomSource& source) {
  const Vector3d half = source.vector(0.1, 1);
  const int sides = static_cast<int>(source.integer(3, 12));
  switch (kind) {
    case RoundPart::Box:
      return Box{half};
    case RoundPart::Cylinder:
      return Cylinder{half.x(), half.z()};
    case RoundPart::Cone:
      return Cone{half.x(), half.z()};
    case RoundPart::Capsule:
      return Capsule{0.4 * half.x(), half.z()};
    default:
      break;
  }
  std::vector<Vector3d> corners;
  for (int i = 0; i < sides; ++i) {
    const double turn = 2 * pi * i / sides;
    for (const double z : {-half.z(), half.z()})
      corners.emplace_back(std::cos(turn) * half.x(), std::sin(turn) * half.y(), z);
  }
  return ConvexHull(corners);
}

Matrix3d turn_of(RandomSource& source) {
  const double angle = source.uniform(-3, 3);
  return AngleAxisd(angle, source.vector(-1, 1).normalized()).toRotationMatrix();
}

/// Upright, on a side or anyhow, and then leaning by as little as a billionth.
Matrix3d nearly_special_turn(RandomSource& source) {
  const int kind = static_cast<int>(source.integer(0, 2));
  const double lean = std::pow(10, source.uniform(-9, -1));
  const Vector3d about = source.vector(-1, 1).normalized();
  const Matrix3d leaning = AngleAxisd(lean, about).toRotationMatrix();
  if (kind == 0) return leaning;
  if (kind == 1) return leaning * AngleAxisd(pi / 2, Vector3d::UnitX()).toRotationMatrix();
  return turn_of(source);
}

struct RoundPair {
  Shape lower, upper;
  Pose of_lower = Pose::Identity(), of_upper = Pose::Identity();
  double size = 0;   ///< of the smaller one, metres
  double scale = 0;  ///< of the pair
};

double width_of(const Shape& shape) {
  Vector3d widths;
  for (int i = 0; i < 3; ++i) {
    const Vector3d way = Vector3d::Unit(i);
    widths[i] = tests::reach_of(shape, Pose::Identity(), way) +
                tests::reach_of(shape, Pose::Identity(), -way);
  }
  return widths.norm();
}

/// Lays the upper one on the lower one or beyond its rim, sunk by up to a tenth of the smaller one.
/// False if it passes the lower one.
bool lay(RoundPair& pair, RandomSource& source) {
  pair.of_upper.linear() = nearly_special_turn(source);
  const double of_lower = width_of(pair.lower), of_upper = width_of(pair.upper);
  pair.size = std::min(of_lower, of_upper);
  const double sunk = pair.size * std::pow(10, source.uniform(-6, -1));
  Vector3d at = 0.3 * (of_lower + of_upper) * source.vector(-1, 1);
  const auto meet_at = [&](double height) {
    at.z() = height;
    pair.of_upper.translation() = at;
    return intersects({pair.lower, pair.of_lower}, {pair.upper, pair.of_upper});
  };
  double touching = 0, clear = of_lower + of_upper;
  if (!meet_at(touching)) return false;
  for (int step = 0; step < 45; ++step) {
    const double middle = 0.5 * (touching + clear);
    (meet_at(middle) ? touching : clear) = middle;
  }
  meet_at(touching - sunk);
  pair.scale = of_lower + of_upper + at.norm();
  return true;
}

std::optional<RoundPair> round_pair(RoundPart lower, RoundPart upper, RandomSource& source) {
  RoundPair pair{.lower = body_of(lower, source), .upper = body_of(upper, source)};
  pair.of_lower.linear() = nearly_special_turn(source);
  if (!lay(pair, source)) return std::nullopt;
  return pair;
}

/// A square of 2 m of so many cells a side, whose corners are up to so high.
Mesh rough_floor(int cells, double height, RandomSource& source) {
  std::vector<Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  const auto corner = [&](int i, int j) { return static_cast<std::uint32_t>(i * (cells + 1) + j); };
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j)
      vertices.emplace_back(2.0 * i / cells - 1, 2.0 * j / cells - 1, source.uniform(0, height));
  }
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      triangles.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
      triangles.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
    }
  }
  return {vertices, std::span<const TriangleIndices>(triangles)};
}

Manifold contacts_of(const RoundPair& pair) {
  return find_contacts({pair.lower, pair.of_lower}, {pair.upper, pair.of_upper});
}

struct Kept {
  int contacts = 0;
  int lasting = 0;  ///< whose feature is there after a move
  int jumped = 0;   ///< of these: by more than twice the move and a millionth of the size
  int turned = 0;   ///< of these: by more than a degree
};

/// Moved so that no point of the upper one goes farther than a ten-thousandth of the size.
void count_kept(const RoundPair& before, RandomSource& source, Kept& kept) {
  const double move = before.size * std::pow(10, source.uniform(-9, -4));
  RoundPair after = before;
  const Vector3d about = source.vector(-1, 1).normalized();
  const double angle = 0.5 * move / width_of(before.upper);
  after.of_upper.linear() = AngleAxisd(angle, about) * before.of_upper.linear();
  after.of_upper.translation() += 0.5 * move * source.vector(-1, 1).normalized();
  const Manifold first = contacts_of(before), then = contacts_of(after);
  for (const ShapeContact& contact : first) {
    ++kept.contacts;
    const auto* const same = std::ranges::find(then, contact.feature, &ShapeContact::feature);
    if (same == then.end()) continue;
    ++kept.lasting;
    kept.jumped += std::abs(contact.depth - same->depth) > 2 * move + 1e-6 * before.size;
    kept.turned += contact.normal.dot(same->normal) < std::cos(pi / 180);
  }
}

// A polytope knows a depth to a millionth of the size and so its direction to a thousandth:
// contacts beside the deepest point were off by that share of how far they were from it, another
// one with each rounding. In one of some 500 lasting contacts of such pairs that was more than the
// motion.
TEST(RoundParts, Law15WhatLastsChangesAsItMoves) {
  RandomSource source(1551);
  Kept kept;
  for (const RoundPart lower : {RoundPart::Cylinder, RoundPart::Cone}) {
    for (const RoundPart upper :
         {RoundPart::Box, RoundPart::Prism, RoundPart::Cylinder, RoundPart::Cone}) {
      for (int n = 0; n < 800; ++n) {
        const std::optional<RoundPair> pair = round_pair(lower, upper, source);
        if (pair) count_kept(*pair, source, kept);
      }
    }
  }
  EXPECT_GT(kept.contacts, 4000);
  EXPECT_GT(kept.lasting, 0.97 * kept.contacts);
  // Where a box leans by far an edge of it and one of an octagon may cross at so small an angle
  // that the crossing moves faster than the box.
  EXPECT_LE(kept.jumped, 1);
  EXPECT_EQ(kept.turned, 0);
}

// About one axis all ways out are as long, and where tips meet they turn with the least motion: the
// point in which two such bodies meet had one name for all of them.
TEST(RoundParts, Law15AnotherWayOutHasAnotherName) {
  RandomSource source(1552);
  Kept kept;
  for (int n = 0; n < 3000; ++n) {
    RoundPair pair{.lower = body_of(RoundPart::Cone, source),
                   .upper = body_of(RoundPart::Cone, source)};
    const double of_lower = width_of(pair.lower), of_upper = width_of(pair.upper);
    pair.size = std::min(of_lower, of_upper);
    const Vector3d about = source.vector(-1, 1).normalized();
    const double lean = std::pow(10, source.uniform(-9, -2));
    pair.of_upper.linear() =
        AngleAxisd(lean, about) * AngleAxisd(pi, Vector3d::UnitX()).toRotationMatrix();
    pair.of_upper.translation() = 1e-3 * pair.size * source.vector(-1, 1);
    pair.of_upper.translation().z() = tests::reach_of(pair.lower, pair.of_lower, {0, 0, 1}) +
                                      tests::reach_of(pair.upper, pair.of_upper, {0, 0, -1}) -
                                      pair.size * std::pow(10, source.uniform(-4, -1));
    count_kept(pair, source, kept);
  }
  EXPECT_GT(kept.contacts, 1500);
  EXPECT_GT(kept.lasting, 0.75 * kept.contacts);
  EXPECT_EQ(kept.jumped, 0);
  // Three where lines on both sides meet next to a tip, by up to 2.1 degrees.
  EXPECT_LE(kept.turned, 3);
}

// Where the deepest point is beyond what is touched another one stands for it: which one had no say
// in its name, nor whose deepest point it was where two are as deep.
TEST(RoundParts, Law15AnotherPointInAValleyHasAnotherName) {
  RandomSource source(1554);
  Kept kept;
  for (int n = 0; n < 6000; ++n) {
    const int cells = static_cast<int>(source.integer(2, 6));
    const double height = source.uniform(0.1, 0.4);
    RoundPair pair{.lower = rough_floor(cells, height, source),
                   .upper = body_of(n % 2 == 0 ? RoundPart::Capsule : RoundPart::Prism, source)};
    if (lay(pair, source)) count_kept(pair, source, kept);
  }
  EXPECT_GT(kept.contacts, 4000);
  EXPECT_GT(kept.lasting, 0.97 * kept.contacts);
  EXPECT_LE(kept.jumped, 2);
  EXPECT_EQ(kept.turned, 0);
}

// Along sides that nearly lie along each other the ends lacked up to a hundred-thousandth of their
// length, or a millionth of the size.
TEST(RoundParts, Law15MovedByTheGreatestDepthTheyPartToRounding) {
  RandomSource source(1553);
  for (const RoundPart lower : {RoundPart::Box, RoundPart::Cylinder, RoundPart::Cone}) {
    for (const RoundPart upper : {RoundPart::Cylinder, RoundPart::Cone, RoundPart::Capsule}) {
      int regions = 0;
      for (int n = 0; n < 700; ++n) {
        const std::optional<RoundPair> pair = round_pair(lower, upper, source);
        if (!pair) continue;
        Work work;
        const Manifold found =
            find_contacts({pair->lower, pair->of_lower}, {pair->upper, pair->of_upper}, &work);
        if (found.empty() || work.penetration_failures > 0) continue;
        double depth = 0;
        for (const ShapeContact& contact : found)
          depth = std::max(depth, contact.depth);
        const auto meet_moved = [&](double by) {
          Pose moved = pair->of_lower;
          moved.translation() -= by * found[0].normal;
          return intersects({pair->lower, moved}, {pair->upper, pair->of_upper});
        };
        const double meeting = 0x1p-33 * pair->scale;
        ASSERT_FALSE(meet_moved(1.001 * depth + meeting))
            << int(lower) << " below " << int(upper) << ", " << n << ": " << depth;
        const double less = 0.95 * depth - 1e-6 * pair->size - meeting;
        ASSERT_TRUE(less < 0 || meet_moved(less)) << depth;
        ++regions;
      }
      EXPECT_GT(regions, 250);
    }
  }
}

}  // namespace
}  // namespace graze
