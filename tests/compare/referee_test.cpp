#include <graze/bvh/error.h>
#include <graze/engine/compare/referee.h>
#include <gtest/gtest.h>
#include <tests/compare/fourier_motzkin.h>
#include <tests/compare/rational_clip.h>
#include <tests/oracle/case_text.h>
#include <tests/oracle/category.h>

#include <cmath>
#include <limits>

namespace graze::compare {
namespace {

using oracle::TriangleAndBox;
using oracle::TrianglePair;

constexpr int kElements = 100;
constexpr int kElementsSlow = 8000;  // a million pairs of triangles in all

void check(const TrianglePair& pair) {
  const bool answer = referee_intersects(pair.a, pair.b);
  EXPECT_EQ(answer, oracle::intersects_by_elimination(pair.a, pair.b)) << to_text(pair, answer);
  if (const auto clipped = oracle::intersects_by_clipping(pair.a, pair.b)) {
    EXPECT_EQ(answer, *clipped) << to_text(pair, answer);
  }
  if (const auto clipped = oracle::intersects_by_clipping(pair.b, pair.a)) {
    EXPECT_EQ(answer, *clipped) << to_text(pair, answer);
  }
}

void check(const TriangleAndBox& pair) {
  const bool answer = referee_intersects(pair.triangle, pair.box);
  EXPECT_EQ(answer, oracle::intersects_by_elimination(pair.triangle, pair.box))
      << to_text(pair, answer);
  EXPECT_EQ(answer, oracle::intersects_by_clipping(pair.triangle, pair.box))
      << to_text(pair, answer);
}

template <typename Element>
void check_corpus(const oracle::Corpus<Element>& corpus, int count) {
  for (int index = 0; index < count && !testing::Test::HasFailure(); ++index) {
    SCOPED_TRACE(corpus.name() + " element " + std::to_string(index));
    check(corpus.element(index));
  }
}

template <typename Corpora>
void check_corpora(const Corpora& corpora, int count) {
  for (const auto& corpus : corpora)
    check_corpus(corpus, count);
}

TEST(Referee, AgreesWithEliminationAndClippingOnPairs) {
  check_corpora(oracle::pair_corpora(), kElements);
}

TEST(Referee, AgreesWithEliminationAndClippingOnBoxes) {
  check_corpora(oracle::box_corpora(), kElements);
}

TEST(RefereeSlow, AgreesWithEliminationAndClippingOnPairs) {
  check_corpora(oracle::pair_corpora(), kElementsSlow);
}

TEST(RefereeSlow, AgreesWithEliminationAndClippingOnBoxes) {
  check_corpora(oracle::box_corpora(), kElementsSlow);
}

// Every triangle with corners in {0, 1}^3 against every one with corners in {0, 1}^2 x {0, 1, 2},
// of which every third is taken: touching in all ways, degenerate in all ways.
TEST(Referee, AgreesOnATinyLatticeThroughout) {
  const auto corner = [](int k, int height) {
    return Eigen::Vector3d(k & 1, k >> 1 & 1, (k >> 2) * height);
  };
  int count = 0;
  for (int code_a = 0; code_a < 512; code_a += 5) {
    for (int code_b = code_a % 3; code_b < 512; code_b += 17) {
      const Triangle a{corner(code_a & 7, 1), corner(code_a >> 3 & 7, 1), corner(code_a >> 6, 1)};
      const Triangle b{corner(code_b & 7, 2), corner(code_b >> 3 & 7, 2), corner(code_b >> 6, 2)};
      check(TrianglePair{a, b});
      ++count;
    }
  }
  EXPECT_GT(count, 3000);
}

// The right triangle with its legs on the axes x and y.
const Triangle kFloor{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

TEST(Referee, KnownTrianglePairs) {
  const double hair = std::numeric_limits<double>::denorm_min();
  EXPECT_TRUE(referee_intersects(kFloor, kFloor));
  EXPECT_TRUE(referee_intersects(kFloor, {{1, 1, 0}, {1, 1, 5}, {2, 2, 5}}));
  EXPECT_FALSE(referee_intersects(kFloor, {{1, 1, hair}, {1, 1, 5}, {2, 2, 5}}));
  EXPECT_TRUE(referee_intersects(kFloor, {{1, 1, -1}, {1, 1, 5}, {9, 9, 5}}));
  EXPECT_FALSE(referee_intersects(kFloor, {{3, 3, -1}, {3, 3, 5}, {9, 9, 5}}));
  EXPECT_TRUE(referee_intersects(kFloor, {{2, 2, -1}, {2, 2, 5}, {9, 9, 5}}));
  EXPECT_TRUE(referee_intersects(kFloor, {{2, 2, 0}, {5, 5, 0}, {9, 5, 0}}));
  EXPECT_FALSE(
      referee_intersects(kFloor, {{2, std::nextafter(2.0, 3.0), 0}, {5, 5, 0}, {9, 5, 0}}));
  EXPECT_TRUE(referee_intersects(kFloor, {{1, 1, 0}, {1, 2, 0}, {2, 1, 0}}));
}

TEST(Referee, KnownDegenerateTriangles) {
  const Triangle point{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}};
  const Triangle corner{{4, 0, 0}, {4, 0, 0}, {4, 0, 0}};
  const Triangle segment{{1, 1, -1}, {1, 1, 3}, {1, 1, 1}};
  EXPECT_TRUE(referee_intersects(kFloor, point));
  EXPECT_TRUE(referee_intersects(kFloor, corner));
  EXPECT_TRUE(referee_intersects(kFloor, segment));
  EXPECT_TRUE(referee_intersects(segment, point));
  EXPECT_FALSE(referee_intersects(segment, corner));
  EXPECT_TRUE(referee_intersects(point, point));
  EXPECT_FALSE(referee_intersects(point, corner));
}

TEST(Referee, KnownBoxes) {
  const Aabb box{{1, 1, 0}, {2, 2, 1}};
  EXPECT_TRUE(referee_intersects(kFloor, box));
  EXPECT_TRUE(referee_intersects(kFloor, Aabb{{2, 2, -1}, {3, 3, 1}}));
  EXPECT_FALSE(referee_intersects(kFloor, Aabb{{2, std::nextafter(2.0, 3.0), -1}, {3, 3, 1}}));
  EXPECT_TRUE(referee_intersects(kFloor, Aabb{{-9, -9, -9}, {9, 9, 9}}));
  EXPECT_TRUE(referee_intersects(kFloor, Aabb{{1, 1, 0}, {1, 1, 0}}));
  EXPECT_FALSE(referee_intersects(kFloor, Aabb{{1, 1, 0x1p-1074}, {1, 1, 1}}));
  EXPECT_TRUE(referee_intersects(kFloor, Aabb{{-1, -1, 0}, {0, 0, 0}}));
}

TEST(Referee, TheEndsOfTheRangeAreNumbersLikeOthers) {
  const double huge = std::numeric_limits<double>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  const Triangle wide{{-huge, -huge, 0}, {huge, -huge, 0}, {0, huge, 0}};
  EXPECT_TRUE(referee_intersects(wide, {{0, 0, 0}, {0, 0, huge}, {tiny, 0, huge}}));
  EXPECT_FALSE(referee_intersects(wide, {{0, 0, tiny}, {0, 0, huge}, {tiny, 0, huge}}));
  EXPECT_TRUE(referee_intersects(
      wide, {{-huge, -huge, -tiny}, {-huge, -huge, tiny}, {-huge, -huge, huge}}));
  EXPECT_FALSE(referee_intersects(wide, Aabb{{-huge, -huge, tiny}, {huge, huge, huge}}));
  EXPECT_TRUE(referee_intersects(wide, Aabb{{-tiny, -tiny, -0.0}, {-tiny, -tiny, huge}}));
}

TEST(Referee, RefusesWhatIsNotFinite) {
  Triangle bad = kFloor;
  bad.b.y() = std::nan("");
  EXPECT_THROW(referee_intersects(kFloor, bad), InputError);
  EXPECT_THROW(referee_intersects(bad, kFloor), InputError);
  EXPECT_THROW(referee_intersects(bad, Aabb{{0, 0, 0}, {1, 1, 1}}), InputError);
  EXPECT_THROW(referee_intersects(kFloor, Aabb{{0, 0, 0}, {1, -1, 1}}), InputError);
  try {
    referee_intersects(kFloor, bad);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "triangle B: coordinate y of vertex b is not finite");
  }
}

}  // namespace
}  // namespace graze::compare
