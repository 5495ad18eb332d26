#include <graze/bvh/error.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using narrowphase::triage;
using narrowphase::Verdict;

const Triangle kFlat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

TEST(TriangleTriangle, CrossingAndApart) {
  EXPECT_TRUE(intersects(kFlat, {{1, 1, -1}, {1, 1, 1}, {2, 1, 1}}));
  EXPECT_FALSE(intersects(kFlat, {{1, 1, 0.1}, {1, 1, 1}, {2, 1, 1}}));
  EXPECT_FALSE(intersects(kFlat, {{5, 5, -1}, {5, 5, 1}, {6, 5, 1}}));
}

TEST(TriangleTriangle, TouchingCountsToTheLastBit) {
  EXPECT_TRUE(intersects(kFlat, {{1, 1, 0}, {1, 1, 1}, {2, 1, 1}})) << "vertex on face";
  EXPECT_TRUE(intersects(kFlat, {{2, 2, 0}, {3, 3, 1}, {3, 3, -1}})) << "vertex on edge";
  EXPECT_TRUE(intersects(kFlat, {{4, 0, 0}, {5, 0, 1}, {5, 0, -1}})) << "vertex on vertex";
  EXPECT_TRUE(intersects(kFlat, {{3, 1, -1}, {3, 1, 1}, {9, 9, 0}})) << "edge crossing edge";
  const double above = std::nextafter(0.0, 1.0);
  EXPECT_FALSE(intersects(kFlat, {{1, 1, above}, {1, 1, 1}, {2, 1, 1}}));
  const double beyond = std::nextafter(2.0, 3.0);
  EXPECT_FALSE(intersects(kFlat, {{beyond, 2, 0}, {3, 3, 1}, {3, 3, -1}}));
}

TEST(TriangleTriangle, Coplanar) {
  EXPECT_TRUE(intersects(kFlat, {{1, 1, 0}, {9, 1, 0}, {1, 9, 0}})) << "overlapping";
  EXPECT_TRUE(intersects(kFlat, {{1, 1, 0}, {1.5, 1, 0}, {1, 1.5, 0}})) << "inside";
  EXPECT_TRUE(intersects(kFlat, {{-9, -9, 0}, {99, -9, 0}, {-9, 99, 0}})) << "around";
  EXPECT_TRUE(intersects(kFlat, {{4, 0, 0}, {9, 0, 0}, {9, 9, 0}})) << "at a vertex";
  EXPECT_TRUE(intersects(kFlat, {{0, 0, 0}, {4, 0, 0}, {0, -4, 0}})) << "along an edge";
  EXPECT_FALSE(intersects(kFlat, {{3, 3, 0}, {9, 3, 0}, {3, 9, 0}}));
}

TEST(TriangleTriangle, SegmentsAndPointsAreWhatTheyAre) {
  const Triangle crossing{{1, 1, -1}, {1, 1, 1}, {1, 1, 0.5}};
  const Triangle beside{{3, 3, -1}, {3, 3, 1}, {3, 3, 1}};
  const Triangle point{{1, 2, 0}, {1, 2, 0}, {1, 2, 0}};
  const Triangle above{{1, 2, 1e-300}, {1, 2, 1e-300}, {1, 2, 1e-300}};
  EXPECT_TRUE(intersects(kFlat, crossing));
  EXPECT_FALSE(intersects(kFlat, beside));
  EXPECT_TRUE(intersects(kFlat, point));
  EXPECT_FALSE(intersects(kFlat, above));
  EXPECT_TRUE(intersects(crossing, {{1, 1, 0.75}, {2, 2, 2}, {3, 3, 3.25}}));
  EXPECT_TRUE(intersects(point, point));
  EXPECT_FALSE(intersects(point, above));
  EXPECT_FALSE(intersects(crossing, point));
}

TEST(Law4, SwappingAndReorderingChangeNothing) {
  RandomSource source(4);
  int hits = 0;
  for (int n = 0; n < 5000; ++n) {
    const bool is_lattice = n % 2 == 0;
    const auto point = [&] {
      return is_lattice ? source.lattice_point(-2, 2) : source.vector(-1, 1);
    };
    const Triangle a{point(), point(), point()};
    const Triangle b{point(), point(), point()};
    const bool expected = intersects(a, b);
    hits += expected;
    for (const Triangle& s :
         {a, Triangle{a.b, a.c, a.a}, Triangle{a.c, a.b, a.a}, Triangle{a.b, a.a, a.c}}) {
      for (const Triangle& t : {b, Triangle{b.c, b.a, b.b}, Triangle{b.c, b.b, b.a}}) {
        ASSERT_EQ(intersects(s, t), expected);
        ASSERT_EQ(intersects(t, s), expected);
      }
    }
  }
  EXPECT_GT(hits, 500);
  EXPECT_LT(hits, 4500);
}

TEST(Law6, GenericPairsAreDecidedWithoutExactArithmetic) {
  RandomSource source(6);
  for (int n = 0; n < 20000; ++n) {
    const auto point = [&] { return source.vector(-1, 1); };
    const Triangle a{point(), point(), point()}, b{point(), point(), point()};
    ASSERT_NE(triage(a, b), Verdict::Unsure);
  }
}

TEST(Law6, AZeroAreaTriangleIsNeverSurelyTouching) {
  RandomSource source(7);
  for (int n = 0; n < 20000; ++n) {
    const Eigen::Vector3d p = source.vector(-1, 1);
    const Eigen::Vector3d q = source.vector(-1, 1);
    const Triangle segment{p, q, n % 2 == 0 ? q : p};
    const Triangle other{source.vector(-1, 1), source.vector(-1, 1), source.vector(-1, 1)};
    ASSERT_NE(triage(segment, other), Verdict::Yes);
    ASSERT_NE(triage(other, segment), Verdict::Yes);
  }
}

TEST(Law6, EqualVerticesCertifyAHitAndDisjointBoxesAMiss) {
  RandomSource source(8);
  for (int n = 0; n < 2000; ++n) {
    const auto point = [&] { return source.vector(-1, 1); };
    const Eigen::Vector3d shared = point();
    const Triangle a{point(), shared, point()};
    const Triangle b{point(), point(), shared};
    ASSERT_EQ(triage(a, b), Verdict::Yes);
    ASSERT_TRUE(narrowphase::intersects_exactly(a, b));
    ASSERT_EQ(triage(a, a), Verdict::Yes);
    ASSERT_EQ(triage(a, {shared, shared, shared}), Verdict::Yes);
  }
  EXPECT_EQ(triage(kFlat, {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}}), Verdict::No) << "in one plane";
  EXPECT_EQ(triage(kFlat, {{4, 1, 0}, {6, 0, 0}, {5, 1, 0}}), Verdict::Unsure);
}

TEST(Law10, EqualVerticesDoNotHideWhatIsNotFinite) {
  for (double bad : {std::nan(""), HUGE_VAL}) {
    const Triangle broken{kFlat.a, {1, bad, 1}, {2, 2, 2}};
    EXPECT_THROW(intersects(kFlat, broken), InputError);
    EXPECT_THROW(intersects(broken, kFlat), InputError);
    EXPECT_THROW(intersects(broken, broken), InputError);
  }
}

TEST(Law6, BeyondTheFiltersRangeItIsUnsure) {
  const auto scaled = [](double scale) {
    return triage({Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(4, 0, 0) * scale,
                   Eigen::Vector3d(0, 4, 0) * scale},
                  {Eigen::Vector3d(1, 1, -1) * scale, Eigen::Vector3d(1, 1, 1) * scale,
                   Eigen::Vector3d(2, 1.5, 1) * scale});
  };
  EXPECT_EQ(scaled(1), Verdict::Yes);
  EXPECT_EQ(scaled(1e-80), Verdict::Yes);
  EXPECT_EQ(scaled(1e40), Verdict::Yes);
  EXPECT_EQ(scaled(1e-100), Verdict::Unsure);
  EXPECT_EQ(scaled(1e-310), Verdict::Unsure);
  EXPECT_EQ(scaled(1e60), Verdict::Unsure);
  EXPECT_EQ(scaled(1e307), Verdict::Unsure);
}

TEST(Law10, CoordinatesThatAreNotFiniteAreRefusedWhereverTheyStand) {
  for (double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (int i = 0; i < 9; ++i) {
      Triangle far{{10, 10, 10}, {11, 10, 10}, {10, 12, 10}};
      Triangle near{{1, 1, -1}, {1, 1, 1}, {2, 1, 1}};
      for (Triangle* broken : {&far, &near}) {
        Eigen::Vector3d* corner[] = {&broken->a, &broken->b, &broken->c};
        (*corner[i / 3])[i % 3] = bad;
        EXPECT_THROW(intersects(kFlat, *broken), InputError) << i;
        EXPECT_THROW(intersects(*broken, kFlat), InputError) << i;
      }
    }
  }
}

TEST(Law10, TheMessageNamesTheCoordinate) {
  try {
    intersects(kFlat, {{0, 0, 0}, {0, std::nan(""), 0}, {1, 1, 1}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "triangle B: coordinate y of vertex b is not finite");
  }
}

}  // namespace
}  // namespace graze
