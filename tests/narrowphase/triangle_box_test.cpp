#include <graze/bvh/error.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/box_frame.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using narrowphase::intersects_exactly;
using narrowphase::triage;
using narrowphase::Verdict;

const Aabb kUnit{{0, 0, 0}, {1, 1, 1}};

TEST(TriangleBox, EachKindOfAxisSeparates) {
  EXPECT_FALSE(intersects({{2, 0, 0}, {3, 0, 0}, {2, 1, 0}}, kUnit)) << "box axis";
  EXPECT_FALSE(intersects({{3.1, 0, 0}, {0, 3.1, 0}, {0, 0, 3.1}}, kUnit)) << "normal";
  EXPECT_TRUE(intersects({{2.9, 0, 0}, {0, 2.9, 0}, {0, 0, 2.9}}, kUnit));
  EXPECT_FALSE(intersects({{2.1, 0, -5}, {0, 2.1, 5}, {9, 9, 0.5}}, kUnit)) << "edge cross product";
}

TEST(TriangleBox, TouchingCountsToTheLastBit) {
  const double beyond = std::nextafter(1.0, 2.0);
  EXPECT_TRUE(intersects({{1, 1, 1}, {2, 2, 2}, {3, 2, 2}}, kUnit)) << "vertex on corner";
  EXPECT_FALSE(intersects({{beyond, 1, 1}, {2, 2, 2}, {3, 2, 2}}, kUnit));
  EXPECT_TRUE(intersects({{2, 0, 0.5}, {0, 2, 0.5}, {2, 2, 0.5}}, kUnit)) << "edge on box edge";
  EXPECT_TRUE(intersects({{3, 0, 0}, {0, 3, 0}, {0, 0, 3}}, kUnit)) << "face on corner";
  EXPECT_FALSE(intersects(
      {{std::nextafter(3.0, 4.0), 0, 0}, {0, 3, 0}, {0, 0, std::nextafter(3.0, 4.0)}}, kUnit));
}

TEST(TriangleBox, FlatBoxesAndPoints) {
  const Triangle slanted{{0, 0, 0}, {4, 0, 4}, {0, 4, 4}};
  EXPECT_TRUE(intersects(slanted, Aabb{{0, 0, 1}, {2, 2, 1}})) << "flat";
  EXPECT_TRUE(intersects(slanted, Aabb{{1, 1, 2}, {1, 1, 2}})) << "a point on the triangle";
  EXPECT_FALSE(intersects(
      slanted, Aabb{{1, 1, std::nextafter(2.0, 3.0)}, {1, 1, std::nextafter(2.0, 3.0)}}));
  EXPECT_TRUE(intersects(slanted, Aabb{{1, 1, 0}, {1, 1, 9}})) << "a segment";
}

TEST(TriangleBox, DegenerateTriangles) {
  EXPECT_TRUE(intersects({{-1, -1, -1}, {2, 2, 2}, {0, 0, 0}}, kUnit));
  EXPECT_TRUE(intersects({{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, kUnit));
  EXPECT_TRUE(intersects({{-1, 0, 0}, {3, 0, 0}, {0.5, 0, 0}}, kUnit))
      << "along an edge of the box";
  EXPECT_FALSE(
      intersects({{2.5, -1, 0.5}, {-1, 2.5 + 1e-9, 0.5}, {-1, 3.5, 0.5}}, {{1, 1, 0}, {2, 2, 1}}));
  EXPECT_FALSE(intersects({{2.5, 0, 0}, {0, 2.5, 1}, {0, 2.5, 1}}, kUnit));
}

// Law 3 gives the box by its minimum and maximum: a centre and half size would round these away.
TEST(Law3, BoxesThatHaveNoExactCentre) {
  const double low = 1;
  const double high = std::nextafter(1e17, 2e17);
  const Aabb box{{low, low, low}, {high, high, high}};
  EXPECT_TRUE(intersects({{high, 2, 2}, {2 * high, 2, 2}, {2 * high, 3, 2}}, box));
  EXPECT_FALSE(
      intersects({{std::nextafter(high, 2e17), 2, 2}, {2 * high, 2, 2}, {2 * high, 3, 2}}, box));
  EXPECT_TRUE(intersects({{1, 2, 2}, {-5, 2, 2}, {-5, 3, 2}}, box));
  EXPECT_FALSE(intersects({{std::nextafter(1.0, 0.0), 2, 2}, {-5, 2, 2}, {-5, 3, 2}}, box));
}

TEST(Law3, OrientedBoxesRoundTheWayIntoTheirFrame) {
  Obb box{Pose::Identity(), {1, 1, 1}};
  box.pose.linear() = Eigen::AngleAxisd(M_PI / 4, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  box.pose.translation() = Eigen::Vector3d(5, 0, 0);
  EXPECT_TRUE(intersects({{5 + 1.41, 0, 0}, {9, 0, 0}, {9, 1, 0}}, box));
  EXPECT_FALSE(intersects({{5 + 1.42, 0, 0}, {9, 0, 0}, {9, 1, 0}}, box));
  const Triangle local =
      narrowphase::into_frame(Triangle{{6, 0, 0}, {5, 1, 0}, {5, 0, 1}}, box.pose);
  const double root = box.pose.linear()(0, 0);
  EXPECT_EQ(local.a, Eigen::Vector3d(root, box.pose.linear()(0, 1), 0));
  EXPECT_EQ(local.c, Eigen::Vector3d(0, 0, 1));
}

TEST(Law4TriangleBox, ReorderingVerticesChangesNothing) {
  RandomSource source(4);
  int hits = 0;
  for (int n = 0; n < 5000; ++n) {
    const auto point = [&] {
      return n % 2 == 0 ? source.lattice_point(-2, 2) : source.vector(-2, 2);
    };
    const Triangle t{point(), point(), point()};
    const Eigen::Vector3d p = point(), q = point();
    const Aabb box{p.cwiseMin(q), p.cwiseMax(q)};
    const bool expected = intersects(t, box);
    hits += expected;
    ASSERT_EQ(intersects_exactly(t, box), expected);
    for (const Triangle& s :
         {Triangle{t.b, t.c, t.a}, Triangle{t.c, t.b, t.a}, Triangle{t.b, t.a, t.c}}) {
      ASSERT_EQ(intersects(s, box), expected);
    }
  }
  EXPECT_GT(hits, 500);
  EXPECT_LT(hits, 4500);
}

TEST(Law6TriangleBox, GenericPairsAreDecidedWithoutExactArithmetic) {
  RandomSource source(6);
  int unsure = 0;
  for (int n = 0; n < 20000; ++n) {
    const Eigen::Vector3d p = source.vector(-1, 1), q = source.vector(-1, 1);
    const Aabb box{p.cwiseMin(q), p.cwiseMax(q)};
    unsure += triage({source.vector(-1, 1), source.vector(-1, 1), source.vector(-1, 1)}, box) ==
              Verdict::Unsure;
  }
  EXPECT_EQ(unsure, 0);
}

TEST(Law10TriangleBox, ATriangleThatOverflowsInTheFrameOfTheBoxIsRefused) {
  Obb box{Pose::Identity(), {1, 1, 1}};
  box.pose.translation().y() = -1.5e308;
  try {
    intersects({{0, 0, 0}, {0, 1.5e308, 0}, {1, 1, 1}}, box);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "triangle in the frame of the box: coordinate x of vertex b is not finite")
        << "infinity times the zeros of the rotation";
  }
}

TEST(Law10TriangleBox, BadValuesAreRefused) {
  const Triangle good{{2, 2, 2}, {3, 3, 3}, {2, 3, 2}};
  for (double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (int i = 0; i < 9; ++i) {
      Triangle broken = good;
      Eigen::Vector3d* corner[] = {&broken.a, &broken.b, &broken.c};
      (*corner[i / 3])[i % 3] = bad;
      EXPECT_THROW(intersects(broken, kUnit), InputError) << i;
      EXPECT_THROW(intersects(broken, Obb{Pose::Identity(), {1, 1, 1}}), InputError) << i;
    }
    for (int i = 0; i < 6; ++i) {
      Aabb broken = kUnit;
      (i < 3 ? broken.min : broken.max)[i % 3] = bad;
      EXPECT_THROW(intersects(good, broken), InputError) << i;
    }
    EXPECT_THROW(intersects(good, Obb{Pose::Identity(), {1, bad, 1}}), InputError);
  }
  EXPECT_THROW(intersects(good, Aabb{{0, 0, 0}, {1, -1, 1}}), InputError);
  Obb skewed{Pose::Identity(), {1, 1, 1}};
  skewed.pose.linear()(0, 1) = 0.1;
  EXPECT_THROW(intersects(good, skewed), PoseError);
}

}  // namespace
}  // namespace graze
