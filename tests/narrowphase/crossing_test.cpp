#include <graze/bvh/error.h>
#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/triangle_pair/crossing_stages.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using narrowphase::crossing_triage;
using narrowphase::Stage;
using narrowphase::Verdict;

const Triangle kFlat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

TEST(TouchPolicy, OnlyInsidesCount) {
  EXPECT_TRUE(crosses(kFlat, {{1, 1, -1}, {1, 1, 1}, {2, 1, 1}}));
  EXPECT_FALSE(crosses(kFlat, {{1, 1, 0}, {1, 1, 1}, {2, 1, 1}})) << "vertex on face";
  EXPECT_TRUE(crosses(kFlat, {{1, 1, -0x1p-1074}, {1, 1, 1}, {2, 1, 1}})) << "just through it";
  EXPECT_FALSE(crosses(kFlat, {{2, 2, 0}, {3, 3, 1}, {3, 3, -1}})) << "vertex on edge";
  EXPECT_FALSE(crosses(kFlat, {{1, 1, 0}, {2, 1, 0}, {1, 1, 1}})) << "edge in face";
  EXPECT_FALSE(crosses(kFlat, {{3, 1, -1}, {3, 1, 1}, {9, 9, 0}})) << "edge crossing edge";
  EXPECT_TRUE(crosses(kFlat, {{1, 1, -1}, {1, 1, 1}, {1, 2, 0}})) << "a vertex in the plane";
  EXPECT_TRUE(crosses(kFlat, {{0, 0, -1}, {0, 0, 1}, {1, 1, 0}})) << "through a vertex and beyond";
  EXPECT_FALSE(crosses(kFlat, {{0, 0, -1}, {0, 0, 1}, {4, 0, 0}})) << "along an edge";
}

TEST(TouchPolicy, CoplanarPairsDoNotCross) {
  EXPECT_FALSE(crosses(kFlat, kFlat));
  EXPECT_FALSE(crosses(kFlat, {{1, 1, 0}, {9, 1, 0}, {1, 9, 0}}));
  EXPECT_FALSE(crosses(kFlat, {{1, 1, 0}, {2, 2, 0}, {1.5, 1.5, 0}})) << "a segment in the plane";
  EXPECT_FALSE(crosses(kFlat, {{1, 1, 0}, {1, 1, 0}, {1, 1, 0}})) << "a point";
  const Triangle upright{{1, 1, -1}, {1, 1, 1}, {1, 1, 0}};
  const Triangle level{{0, 1, 0}, {2, 1, 0}, {2, 1, 0}};
  EXPECT_FALSE(crosses(upright, level)) << "two segments that meet";
  EXPECT_TRUE(intersects(upright, level));
  EXPECT_FALSE(crosses(upright, upright));
}

TEST(TouchPolicy, ASegmentPiercesTheInside) {
  EXPECT_TRUE(crosses(kFlat, {{1, 1, -1}, {1, 1, 1}, {1, 1, 0.5}}));
  EXPECT_TRUE(crosses({{1, 1, 1}, {1, 1, 0}, {1, 1, -1}}, kFlat)) << "a vertex in the plane";
  EXPECT_FALSE(crosses(kFlat, {{1, 1, 0}, {1, 1, 1}, {1, 1, 1}})) << "an end in the face";
  EXPECT_FALSE(crosses(kFlat, {{2, 2, -1}, {2, 2, 1}, {2, 2, 1}})) << "through an edge";
  EXPECT_FALSE(crosses(kFlat, {{0, 4, -1}, {0, 4, 1}, {0, 4, 1}})) << "through a vertex";
  EXPECT_FALSE(crosses(kFlat, {{3, 3, -1}, {3, 3, 1}, {3, 3, 1}}));
}

TEST(TouchPolicy, GenericCrossingsAreSureWithoutExactArithmetic) {
  RandomSource source(11);
  int crossings = 0;
  for (int n = 0; n < 20000; ++n) {
    const auto point = [&] { return source.vector(-1, 1); };
    const Triangle a{point(), point(), point()};
    const Triangle b{point(), point(), point()};
    const narrowphase::Decision decision = narrowphase::decide(a, b, Touch::Exclude);
    ASSERT_EQ(decision.stage, Stage::Triage);
    ASSERT_EQ(decision.is_hit, intersects(a, b)) << "at random nothing merely touches";
    crossings += decision.is_hit;
  }
  EXPECT_GT(crossings, 1000);
}

TEST(TouchPolicy, TheTriageIsSureOfNothingThatTouches) {
  EXPECT_EQ(crossing_triage(kFlat, {{1, 1, 0}, {1, 1, 1}, {2, 1, 1}}), Verdict::Unsure);
  EXPECT_EQ(crossing_triage(kFlat, kFlat), Verdict::Unsure);
  EXPECT_EQ(crossing_triage(kFlat, {{1, 1, -1}, {1, 1, 1}, {1, 1, 1}}), Verdict::Unsure);
  EXPECT_EQ(narrowphase::decide(kFlat, kFlat, Touch::Exclude).stage, Stage::Exact);
}

TEST(TouchPolicy, IncludeIsLawTwo) {
  RandomSource source(12);
  for (int n = 0; n < 3000; ++n) {
    const auto point = [&] { return source.lattice_point(-2, 2); };
    const Triangle a{point(), point(), point()};
    const Triangle b{point(), point(), point()};
    ASSERT_EQ(intersects(a, b, Touch::Include), intersects(a, b));
    ASSERT_EQ(intersects(a, b, Touch::Exclude), crosses(a, b));
  }
}

TEST(Law10TouchPolicy, BadInputIsRefused) {
  for (double bad : {std::nan(""), HUGE_VAL}) {
    for (int i = 0; i < 9; ++i) {
      Triangle broken{{1, 1, -1}, {1, 1, 1}, {2, 1, 1}};
      Eigen::Vector3d* corner[] = {&broken.a, &broken.b, &broken.c};
      (*corner[i / 3])[i % 3] = bad;
      EXPECT_THROW(crosses(kFlat, broken), InputError) << i;
      EXPECT_THROW(crosses(broken, kFlat), InputError) << i;
      EXPECT_EQ(crossing_triage(broken, kFlat), Verdict::Unsure) << i;
    }
  }
  EXPECT_THROW(intersects(kFlat, kFlat, static_cast<Touch>(7)), InputError);
}

}  // namespace
}  // namespace graze
