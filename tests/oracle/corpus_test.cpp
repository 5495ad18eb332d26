#include <graze/engine/compare/referee.h>
#include <gtest/gtest.h>
#include <tests/oracle/category.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <set>

namespace graze::oracle {
namespace {

constexpr int kElements = 600;

bool truth(const TrianglePair& pair) {
  return compare::referee_intersects(pair.a, pair.b);
}
bool truth(const TriangleAndBox& pair) {
  return compare::referee_intersects(pair.triangle, pair.box);
}

std::vector<double> coordinates(const TrianglePair& pair) {
  std::vector<double> values;
  for (const Eigen::Vector3d& p : {pair.a.a, pair.a.b, pair.a.c, pair.b.a, pair.b.b, pair.b.c}) {
    values.insert(values.end(), p.data(), p.data() + 3);
  }
  return values;
}

std::vector<double> coordinates(const TriangleAndBox& pair) {
  std::vector<double> values;
  const Triangle& t = pair.triangle;
  for (const Eigen::Vector3d& p : {t.a, t.b, t.c, pair.box.min, pair.box.max}) {
    values.insert(values.end(), p.data(), p.data() + 3);
  }
  return values;
}

template <typename Element>
void check_shares(const std::vector<Corpus<Element>>& corpora) {
  for (const Corpus<Element>& corpus : corpora) {
    int hits = 0;
    for (int index = 0; index < kElements; ++index)
      hits += truth(corpus.element(index));
    const double percent = 100.0 * hits / kElements;
    testing::Test::RecordProperty(corpus.name(), std::to_string(percent));
    if (corpus.category.answers == Answers::Intersects) {
      EXPECT_EQ(hits, kElements) << corpus.name();
    } else {
      EXPECT_GE(percent, 5) << corpus.name();
      EXPECT_LE(percent, 95) << corpus.name();
    }
  }
}

TEST(Corpus, PairsHaveBothAnswers) {
  check_shares(pair_corpora());
}
TEST(Corpus, BoxesHaveBothAnswers) {
  check_shares(box_corpora());
}

template <typename Element>
void check_names(const std::vector<Corpus<Element>>& corpora) {
  std::set<std::string> names;
  for (const Corpus<Element>& corpus : corpora) {
    EXPECT_TRUE(names.insert(corpus.name()).second) << corpus.name();
  }
}

TEST(Corpus, NamesAreUnique) {
  check_names(pair_corpora());
  check_names(box_corpora());
}

bool is_float(double value) {
  volatile float narrow = static_cast<float>(value);
  return narrow == value;
}

template <typename Element>
void check_coordinates(const std::vector<Corpus<Element>>& corpora) {
  for (const Corpus<Element>& corpus : corpora) {
    for (int index = 0; index < kElements; ++index) {
      for (const double value : coordinates(corpus.element(index))) {
        ASSERT_TRUE(std::isfinite(value)) << corpus.name() << " element " << index;
        if (corpus.grid == Grid::Float) {
          ASSERT_TRUE(is_float(value)) << corpus.name() << " element " << index;
        }
      }
    }
  }
}

TEST(Corpus, CoordinatesAreFiniteAndOnTheirGrid) {
  check_coordinates(pair_corpora());
  check_coordinates(box_corpora());
}

TEST(Corpus, BoxesAreBoxes) {
  for (const Corpus<TriangleAndBox>& corpus : box_corpora()) {
    for (int index = 0; index < kElements; ++index) {
      EXPECT_NO_THROW(check_box(corpus.element(index).box, "box"))
          << corpus.name() << " element " << index;
    }
  }
}

// One number for all coordinates of the first elements of all corpora.
template <typename Element>
std::uint64_t fingerprint(const std::vector<Corpus<Element>>& corpora) {
  std::uint64_t hash = 0;
  for (const Corpus<Element>& corpus : corpora) {
    for (int index = 0; index < 50; ++index) {
      for (const double value : coordinates(corpus.element(index))) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15ULL;
        hash ^= hash >> 32;
      }
    }
  }
  return hash;
}

// A category and an index name the same element on every machine and with every compiler. Whoever
// changes a recipe puts the new number here.
TEST(Corpus, IsTheSameEverywhere) {
  EXPECT_EQ(fingerprint(pair_corpora()), 0u);
  EXPECT_EQ(fingerprint(box_corpora()), 0u);
}

TEST(Sampler, NudgesByNeighbours) {
  Sampler doubles(1, Grid::Double);
  Sampler floats(1, Grid::Float);
  std::set<double> seen_doubles;
  std::set<double> seen_floats;
  for (int i = 0; i < 200; ++i) {
    seen_doubles.insert(doubles.nudged(1.0, 1));
    seen_floats.insert(floats.nudged(1.0, 1));
  }
  EXPECT_EQ(seen_doubles, (std::set<double>{1 - 0x1p-53, 1, 1 + 0x1p-52}));
  EXPECT_EQ(seen_floats, (std::set<double>{1 - 0x1p-24, 1, 1 + 0x1p-23}));
}

TEST(Sampler, IntegersReachBothEnds) {
  Sampler sampler(7, Grid::Double);
  std::set<int> seen;
  for (int i = 0; i < 300; ++i)
    seen.insert(sampler.integer(-2, 2));
  EXPECT_EQ(seen, (std::set<int>{-2, -1, 0, 1, 2}));
}

}  // namespace
}  // namespace graze::oracle
