#include <gmpxx.h>
#include <graze/bvh/build/build.h>
#include <graze/bvh/skins/fit_skins.h>
#include <graze/bvh/skins/kdop_separation.h>
#include <graze/bvh/skins/obb_separation.h>
#include <graze/bvh/skins/skin_of_one.h>
#include <graze/bvh/skins/sphere_separation.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/bvh/random_boxes.h"
#include "tests/shapes/random_meshes.h"

namespace graze::bvh {
namespace {

/// A tree over primitives that are the two opposite corners of boxes.
struct Fitted {
  std::vector<Eigen::Vector3d> points;
  Tree tree;
  Hulls hulls;

  explicit Fitted(const std::vector<Aabb>& boxes)
      : points(corners(boxes)), tree(build(boxes)), hulls(tree, points, 2) {}

  static std::vector<Eigen::Vector3d> corners(const std::vector<Aabb>& boxes) {
    std::vector<Eigen::Vector3d> result;
    for (const Aabb& box : boxes) {
      result.push_back(box.min);
      result.push_back(box.max);
    }
    return result;
  }
};

/// A point in the local frame of a tree, exactly.
struct Exact {
  mpq_class x[3];

  Exact(const LocalFrame& frame, const Eigen::Vector3d& point) {
    for (int k = 0; k < 3; ++k) {
      x[k] = mpq_class(point.data()[k]) - mpq_class(frame.centre[k]);
      const unsigned long shift = static_cast<unsigned long>(std::abs(frame.exponent));
      if (frame.exponent > 0) mpq_div_2exp(x[k].get_mpq_t(), x[k].get_mpq_t(), shift);
      if (frame.exponent < 0) mpq_mul_2exp(x[k].get_mpq_t(), x[k].get_mpq_t(), shift);
    }
  }
};

bool holds(const FloatSphere& sphere, const Exact& point) {
  mpq_class square = 0;
  for (int k = 0; k < 3; ++k) {
    const mpq_class way = point.x[k] - mpq_class(sphere.centre[k]);
    square += way * way;
  }
  const mpq_class radius(sphere.radius);
  return square <= radius * radius;
}

bool holds(const FloatKDop& kdop, const Exact& point) {
  for (int slab = 0; slab < KDop<18>::kSlabs; ++slab) {
    mpq_class along = 0;
    for (int k = 0; k < 3; ++k)
      along += point.x[k] * kKDopDirections<18>[slab][k];
    if (along < mpq_class(kdop.min[slab]) || along > mpq_class(kdop.max[slab])) return false;
  }
  return true;
}

/// Along the axes as they are in float. The box promises more: its points along the rotation that
/// the axes stand for.
bool holds(const FloatObb& box, const Exact& point) {
  for (int i = 0; i < 3; ++i) {
    mpq_class along = 0;
    for (int k = 0; k < 3; ++k)
      along += mpq_class(box.axes[i][k]) * (point.x[k] - mpq_class(box.centre[k]));
    if (abs(along) > mpq_class(box.half[i])) return false;
  }
  return true;
}

/// Checks each node against the points of all leaves below it.
template <typename Volume>
void expect_nodes_hold_their_points(const Fitted& fitted, const std::vector<Volume>& skin) {
  const Tree& tree = fitted.tree;
  ASSERT_EQ(skin.size(), tree.nodes.size());
  std::vector<std::vector<std::uint32_t>> below(tree.nodes.size());
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const Node& node = tree.nodes[i];
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
      below[i].push_back(tree.primitives[k]);
    if (!node.is_leaf()) {
      below[i] = below[node.first];
      below[i].insert(below[i].end(), below[node.first + 1].begin(), below[node.first + 1].end());
    }
    for (const std::uint32_t primitive : below[i]) {
      ASSERT_TRUE(holds(skin[i], Exact(tree.frame, fitted.points[2 * primitive]))) << i;
      ASSERT_TRUE(holds(skin[i], Exact(tree.frame, fitted.points[2 * primitive + 1]))) << i;
    }
  }
}

class Law5SkinsOn : public testing::TestWithParam<Distribution> {};

INSTANTIATE_TEST_SUITE_P(Distributions, Law5SkinsOn, testing::ValuesIn(kDistributions),
                         testing::PrintToStringParamName());

TEST_P(Law5SkinsOn, EachNodeHoldsItsPointsExactly) {
  const Fitted fitted(random_boxes(GetParam(), 120, 3));
  expect_nodes_hold_their_points(fitted, fit_spheres(fitted.tree, fitted.hulls));
  expect_nodes_hold_their_points(fitted, fit_kdops(fitted.tree, fitted.hulls));
  expect_nodes_hold_their_points(fitted, fit_obbs(fitted.tree, fitted.hulls));
}

TEST(Hulls, RefuseAnotherNumberOfPoints) {
  const Fitted fitted(random_boxes(Distribution::Uniform, 10, 1));
  EXPECT_THROW(Hulls(fitted.tree, fitted.points, 3), InputError);
}

double component(const KDopCombination& combination, int k) {
  double sum = 0;
  for (int term = 0; term < 3; ++term) {
    const double weight = combination.along[term] + combination.against[term];
    sum += weight * kKDopDirections<18>[combination.slab[term]][k];
  }
  return sum;
}

TEST(KDopCombination, IsTheDirectionWithNoWeightLost) {
  RandomSource source(1);
  for (int n = 0; n < 10000; ++n) {
    Eigen::Vector3d d = n % 2 == 0 ? source.vector(-1, 1) : source.lattice_point(-2, 2);
    const KDopCombination combination = combination_of({d[0], d[1], d[2]});
    double length = 0;
    for (int term = 0; term < 3; ++term) {
      ASSERT_GE(combination.along[term], 0);
      ASSERT_LE(combination.against[term], 0);
      ASSERT_TRUE(combination.along[term] == 0 || combination.against[term] == 0);
      length += combination.along[term] - combination.against[term];
    }
    for (int k = 0; k < 3; ++k)
      ASSERT_NEAR(component(combination, k), d[k], 4e-16);
    // A face's corners: of all combinations the one with the least sum of weights, which is the
    // largest component or half the sum of all, whichever is more.
    const double largest = d.cwiseAbs().maxCoeff();
    ASSERT_NEAR(length, std::max(largest, 0.5 * d.cwiseAbs().sum()), 4e-16);
  }
}

RelativeFrame frame_of(const Pose& pose, double slack) {
  RelativeFrame frame;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      frame.rotation[i][j] = pose.linear()(i, j);
    frame.translation[i] = pose.translation()[i];
  }
  frame.units_a = frame.units_b = 1;
  frame.slack = slack;
  return frame;
}

/// A point in common: A's node is fitted to points that include it, B's to points that include it
/// as seen from B. Both are extreme, so that the volumes just touch.
TEST(Law5Skins, NeverApartWithACommonPoint) {
  RandomSource source(2);
  int found_apart[3] = {0, 0, 0};
  for (int n = 0; n < 3000; ++n) {
    const Pose pose = tests::random_pose(1, source);
    const Eigen::Vector3d touching = source.vector(-0.5, 0.5);
    const Eigen::Vector3d outward = source.vector(-1, 1).normalized();
    std::vector<Aabb> boxes_a, boxes_b, boxes_away;
    const auto add = [](std::vector<Aabb>& boxes, const Eigen::Vector3d& p) {
      boxes.push_back({p, p});
    };
    add(boxes_a, touching);
    add(boxes_b, pose.inverse() * touching);
    for (int i = 0; i < 5; ++i) {
      const Eigen::Vector3d a = source.vector(-0.3, 0.3), b = source.vector(-0.3, 0.3);
      add(boxes_a, touching + a - std::max(0.0, a.dot(outward)) * outward);
      add(boxes_b, pose.inverse() * (touching + b - std::min(0.0, b.dot(outward)) * outward));
    }
    // Leaves of one node, in a frame of units 1 about the origin.
    const auto fitted = [](const std::vector<Aabb>& boxes) {
      Fitted result(boxes);
      result.tree = build(boxes, {.max_leaf_size = 100, .primitive_cost = 0.01f});
      result.tree.frame = {{0, 0, 0}, 0};
      result.hulls = Hulls(result.tree, result.points, 2);
      return result;
    };
    const Fitted a = fitted(boxes_a), b = fitted(boxes_b);
    const auto spheres_a = fit_spheres(a.tree, a.hulls), spheres_b = fit_spheres(b.tree, b.hulls);
    const auto obbs_a = fit_obbs(a.tree, a.hulls), obbs_b = fit_obbs(b.tree, b.hulls);
    const auto kdops_a = fit_kdops(a.tree, a.hulls), kdops_b = fit_kdops(b.tree, b.hulls);
    const RelativeFrame frame = frame_of(pose, 1e-13);
    ASSERT_FALSE(SphereSeparation(frame, spheres_a, spheres_b).are_apart(0, 0)) << n;
    ASSERT_FALSE(ObbSeparation(frame, obbs_a, obbs_b).are_apart(0, 0)) << n;
    ASSERT_FALSE(KDopSeparation(frame, kdops_a, kdops_b).are_apart(0, 0)) << n;
    Pose away = pose;
    away.translation() += 0.5 * outward;
    const RelativeFrame frame_away = frame_of(away, 1e-13);
    found_apart[0] += SphereSeparation(frame_away, spheres_a, spheres_b).are_apart(0, 0);
    found_apart[1] += ObbSeparation(frame_away, obbs_a, obbs_b).are_apart(0, 0);
    found_apart[2] += KDopSeparation(frame_away, kdops_a, kdops_b).are_apart(0, 0);
  }
  EXPECT_GT(found_apart[0], 1500);
  EXPECT_GT(found_apart[1], 2500);
  EXPECT_GT(found_apart[2], 2500);
}

// Along each axis and both ways: within the slack nothing is apart, well beyond it all is.
TEST(Law5Skins, TheSlackIsAdded) {
  constexpr double kSlack = 0.1;
  const FloatBox cube{{-1, -1, -1}, {1, 1, 1}};
  const std::vector<FloatSphere> spheres{sphere_around(cube)};
  const std::vector<FloatObb> obbs{obb_around(cube)};
  const std::vector<FloatKDop> kdops{kdop_around(cube)};
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const auto frame_at = [&](double distance) {
        Pose pose = Pose::Identity();
        pose.translation()[axis] = sign * distance;
        return frame_of(pose, kSlack);
      };
      const double touching = 2.0 * spheres[0].radius;
      const RelativeFrame near = frame_at(touching + 0.09), far = frame_at(touching + 0.11);
      EXPECT_FALSE(SphereSeparation(near, spheres, spheres).are_apart(0, 0));
      EXPECT_TRUE(SphereSeparation(far, spheres, spheres).are_apart(0, 0));
      const RelativeFrame close = frame_at(2.09), away = frame_at(2.5);
      EXPECT_FALSE(ObbSeparation(close, obbs, obbs).are_apart(0, 0));
      EXPECT_TRUE(ObbSeparation(away, obbs, obbs).are_apart(0, 0));
      EXPECT_FALSE(KDopSeparation(close, kdops, kdops).are_apart(0, 0));
      EXPECT_TRUE(KDopSeparation(away, kdops, kdops).are_apart(0, 0));
    }
  }
}

FloatKDop with_halves(float half) {
  FloatKDop kdop;
  for (int slab = 0; slab < KDop<18>::kSlabs; ++slab) {
    kdop.min[slab] = -half;
    kdop.max[slab] = half;
  }
  return kdop;
}

// Sharp: a k-DOP that is thin along one slab, beside one that is not, is found apart along that
// slab alone, whichever of the two it is and whichever way.
TEST(KDopSeparation, EachSlabOfEitherSideCounts) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.35, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const std::vector<FloatKDop> wide{with_halves(1)};
  for (int slab = 0; slab < KDop<18>::kSlabs; ++slab) {
    const auto& d = kKDopDirections<18>[slab];
    const Eigen::Vector3d direction(d[0], d[1], d[2]);
    std::vector<FloatKDop> thin = wide;
    thin[0].min[slab] = -0.1f;
    thin[0].max[slab] = 0.1f;
    // Just beyond the wide one's reach along a direction in its own frame.
    const auto beyond = [&](const Eigen::Vector3d& in_wide) {
      const KDopCombination combination = combination_of({in_wide[0], in_wide[1], in_wide[2]});
      double reach = 0.15;
      for (int term = 0; term < 3; ++term)
        reach += combination.along[term] - combination.against[term];
      return reach / direction.squaredNorm();
    };
    Pose pose = Pose::Identity();
    pose.linear() = turn;
    for (const double sign : {-1.0, 1.0}) {
      pose.translation() = sign * beyond(turn.transpose() * direction) * direction;
      EXPECT_TRUE(KDopSeparation(frame_of(pose, 1e-13), thin, wide).are_apart(0, 0)) << slab;
      EXPECT_FALSE(KDopSeparation(frame_of(pose, 1e-13), wide, wide).are_apart(0, 0)) << slab;
      pose.translation() = sign * beyond(turn * direction) * (turn * direction);
      EXPECT_TRUE(KDopSeparation(frame_of(pose, 1e-13), wide, thin).are_apart(0, 0)) << slab;
      EXPECT_FALSE(KDopSeparation(frame_of(pose, 1e-13), wide, wide).are_apart(0, 0)) << slab;
    }
  }
}

TEST(Law5Skins, NothingIsProvedByNanOrInfinity) {
  const FloatBox cube{{-1, -1, -1}, {1, 1, 1}};
  const std::vector<FloatSphere> spheres{sphere_around(cube)};
  const std::vector<FloatObb> obbs{obb_around(cube)};
  const std::vector<FloatKDop> kdops{kdop_around(cube)};
  const double infinity = std::numeric_limits<double>::infinity();
  Pose pose = Pose::Identity();
  for (const double x : {std::nan(""), infinity, 1e300}) {
    pose.translation().x() = x;
    const RelativeFrame frame = frame_of(pose, infinity);
    EXPECT_FALSE(SphereSeparation(frame, spheres, spheres).are_apart(0, 0)) << x;
    EXPECT_FALSE(ObbSeparation(frame, obbs, obbs).are_apart(0, 0)) << x;
    EXPECT_FALSE(KDopSeparation(frame, kdops, kdops).are_apart(0, 0)) << x;
  }
}

TEST(SkinOfOne, HoldsTheCornersOfItsBox) {
  RandomSource source(3);
  const LocalFrame frame{{0, 0, 0}, 0};
  for (int n = 0; n < 200; ++n) {
    const Eigen::Vector3d p = source.vector(-2, 2), q = source.vector(-2, 2);
    const FloatBox box = frame.to_local({p.cwiseMin(q), p.cwiseMax(q)});
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d point(corner & 1 ? box.max[0] : box.min[0],
                                  corner & 2 ? box.max[1] : box.min[1],
                                  corner & 4 ? box.max[2] : box.min[2]);
      const Exact exact(frame, point);
      ASSERT_TRUE(holds(sphere_around(box), exact));
      ASSERT_TRUE(holds(obb_around(box), exact));
      ASSERT_TRUE(holds(kdop_around(box), exact));
    }
  }
}

TEST(SkinOfOne, HoldsTheSphereExactly) {
  RandomSource source(4);
  for (int n = 0; n < 2000; ++n) {
    const double scale = std::ldexp(1.0, static_cast<int>(source.integer(-30, 30)));
    const Eigen::Vector3d p = source.vector(-2, 2) * scale, q = source.vector(-2, 2) * scale;
    const LocalFrame frame = LocalFrame::around({p.cwiseMin(q), p.cwiseMax(q)});
    const Eigen::Vector3d centre = source.vector(-2, 2) * scale;
    const double radius = scale * std::pow(10.0, -source.uniform(0, 9));
    const FloatSphere local = to_local(frame, {centre, radius});
    const Exact exact(frame, centre);
    const mpq_class spare =
        mpq_class(local.radius) - mpq_class(std::ldexp(radius, -frame.exponent));
    mpq_class square = 0;
    for (int k = 0; k < 3; ++k) {
      const mpq_class way = exact.x[k] - mpq_class(local.centre[k]);
      square += way * way;
    }
    ASSERT_TRUE(spare > 0 && spare * spare >= square) << n;
    const FloatKDop kdop = kdop_around(local);
    for (int slab = 0; slab < KDop<18>::kSlabs; ++slab) {
      mpq_class along = 0;
      int ones = 0;
      for (int k = 0; k < 3; ++k) {
        along += mpq_class(local.centre[k]) * kKDopDirections<18>[slab][k];
        ones += std::abs(kKDopDirections<18>[slab][k]);
      }
      const mpq_class above = mpq_class(kdop.max[slab]) - along;
      const mpq_class below = along - mpq_class(kdop.min[slab]);
      const mpq_class reach = mpq_class(local.radius) * local.radius * ones;
      ASSERT_TRUE(above > 0 && above * above >= reach) << n << ", " << slab;
      ASSERT_TRUE(below > 0 && below * below >= reach) << n << ", " << slab;
    }
  }
}

}  // namespace
}  // namespace graze::bvh
