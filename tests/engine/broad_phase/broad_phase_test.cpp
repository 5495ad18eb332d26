#include <graze/engine/world/broad_phase.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>

#include "tests/engine/broad_phase/box_histories.h"

namespace graze {
namespace {

using test::Chance;
using test::Habitat;
using Pairs = std::vector<BoxPair>;

/// What a broad phase should say, by comparing all boxes with all.
class Reference {
 public:
  void set(BoxId id, const Aabb& box) { boxes_[id.index] = {id, box}; }
  void remove(BoxId id) { boxes_.erase(id.index); }
  std::size_t size() const { return boxes_.size(); }
  std::pair<BoxId, Aabb> pick(Chance& chance) const {
    auto at = boxes_.begin();
    std::advance(at, chance.below(static_cast<std::uint32_t>(boxes_.size())));
    return at->second;
  }
  Pairs pairs() const {
    Pairs all;
    for (auto s = boxes_.begin(); s != boxes_.end(); ++s) {
      for (auto t = std::next(s); t != boxes_.end(); ++t) {
        if (test::share_point(s->second.second, t->second.second))
          all.push_back({s->first, t->first});
      }
    }
    return all;
  }
  std::vector<std::uint32_t> overlapping(const Aabb& box) const {
    std::vector<std::uint32_t> all;
    for (const auto& [index, entry] : boxes_) {
      if (test::share_point(entry.second, box)) all.push_back(index);
    }
    return all;
  }

 private:
  std::map<std::uint32_t, std::pair<BoxId, Aabb>> boxes_;
};

Pairs list(std::span<const BoxPair> pairs) {
  return {pairs.begin(), pairs.end()};
}

Pairs sorted(Pairs pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Pairs difference(const Pairs& left, const Pairs& right) {
  Pairs rest;
  std::set_difference(left.begin(), left.end(), right.begin(), right.end(),
                      std::back_inserter(rest));
  return rest;
}

/// A broad phase and its reference, through the same history.
class History {
 public:
  History(Habitat habitat, std::uint64_t seed, std::uint32_t limit, int threads = 1)
      : habitat_(habitat), chance_(seed), limit_(limit), broad_({.threads = threads}) {}

  void change() {
    const std::uint32_t what = chance_.below(10);
    if (reference_.size() < 2 || (what < 2 && reference_.size() < limit_)) {
      const Aabb box = test::random_box(habitat_, chance_);
      reference_.set(broad_.add(box), box);
    } else if (what == 2) {
      const BoxId id = reference_.pick(chance_).first;
      broad_.remove(id);
      reference_.remove(id);
      EXPECT_THROW(broad_.move(id, Aabb{}), StaleIdError);
      EXPECT_FALSE(broad_.contains(id));
    } else if (what == 3 && chance_.one_in(8)) {
      move_many();
    } else {
      move_one();
    }
  }

  void check() {
    broad_.update();
    const Pairs now = reference_.pairs();
    const Pairs unsorted = list(broad_.pairs());
    ASSERT_EQ(sorted(unsorted), now);
    if (chance_.one_in(2)) {
      ASSERT_EQ(list(broad_.sorted_pairs()), now);
    }
    if (chance_.one_in(3)) {
      // Nobody has to ask for what began and ended.
    } else {
      ASSERT_EQ(list(broad_.begun()), difference(now, before_));
      ASSERT_EQ(list(broad_.ended()), difference(before_, now));
    }
    ASSERT_EQ(list(broad_.pairs()), unsorted);
    ASSERT_EQ(broad_.size(), reference_.size());
    before_ = now;
  }

  /// At any time, before an update or after one.
  void check_query() {
    const Aabb box = test::random_box(habitat_, chance_);
    std::vector<std::uint32_t> found;
    broad_.find_overlapping(box, found);
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, reference_.overlapping(box));
  }

  void check_box() {
    const auto [id, box] = reference_.pick(chance_);
    const Aabb kept = broad_.box(id);
    ASSERT_EQ(kept.min, box.min);
    ASSERT_EQ(kept.max, box.max);
    ASSERT_EQ(broad_.id(id.index), id);
  }

  Chance& chance() { return chance_; }
  const BroadPhaseWork& work() const { return broad_.work(); }

 private:
  Aabb elsewhere(const Aabb& box) {
    return chance_.one_in(4) ? test::random_box(habitat_, chance_)
                             : test::stepped(box, habitat_, chance_);
  }
  void move_one() {
    const auto [id, box] = reference_.pick(chance_);
    const Aabb next = elsewhere(box);
    broad_.move(id, next);
    reference_.set(id, next);
  }
  void move_many() {
    std::vector<BoxId> ids;
    std::vector<Aabb> boxes;
    const std::uint32_t count = chance_.below(static_cast<std::uint32_t>(2 * reference_.size()));
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto [id, box] = reference_.pick(chance_);
      ids.push_back(id);
      boxes.push_back(elsewhere(box));
      reference_.set(id, boxes.back());
    }
    broad_.move(ids, boxes);
  }

  Habitat habitat_;
  Chance chance_;
  std::uint32_t limit_;
  BroadPhase broad_;
  Reference reference_;
  Pairs before_;
};

class BroadPhaseHistory : public testing::TestWithParam<Habitat> {};

/// Law 9: as if all boxes were compared with all, whatever happens to them.
TEST_P(BroadPhaseHistory, EqualsBruteForce) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    History history(GetParam(), seed, 40 * static_cast<std::uint32_t>(seed));
    for (int operations = 0; operations < 4000;) {
      const std::uint32_t changes =
          history.chance().one_in(3) ? history.chance().below(60) : history.chance().below(5);
      for (std::uint32_t i = 0; i < changes; ++i, ++operations)
        history.change();
      history.check_query();
      history.check();
      history.check_query();
      if (operations > 10) history.check_box();
      if (HasFatalFailure()) return;
      ++operations;
    }
    EXPECT_GT(history.work().searches_for_all, 10u);
    EXPECT_GT(history.work().searches_for_movers, 10u);
  }
}

class BroadPhaseHistorySlow : public testing::TestWithParam<Habitat> {};

TEST_P(BroadPhaseHistorySlow, OfAHundredThousandOperationsEqualsBruteForce) {
  for (std::uint64_t seed = 100; seed < 120; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    History history(GetParam(), seed, 20 + 10 * static_cast<std::uint32_t>(seed % 10), 2);
    for (int operations = 0; operations < 5000 && !HasFatalFailure(); ++operations) {
      history.change();
      if (history.chance().one_in(5)) history.check_query();
      if (history.chance().one_in(4)) history.check();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Habitats, BroadPhaseHistorySlow, testing::ValuesIn(test::kHabitats));
INSTANTIATE_TEST_SUITE_P(Habitats, BroadPhaseHistory, testing::ValuesIn(test::kHabitats));

/// Trees of several levels, sorted again and again.
TEST_P(BroadPhaseHistory, EqualsBruteForceWithThousands) {
  const Habitat habitat = GetParam();
  const std::uint32_t count =
      habitat == Habitat::OnePoint || habitat == Habitat::Extreme ? 300 : 1500;
  History history(habitat, 7, count, 2);
  for (std::uint32_t i = 0; i < 5 * count; ++i)
    history.change();
  history.check();
  for (const std::uint32_t changes : {1u, 10u, 60u, 2u, 1500u, 3u, 40u}) {
    for (std::uint32_t i = 0; i < changes; ++i)
      history.change();
    history.check();
    if (HasFatalFailure()) return;
  }
}

TEST(BroadPhase, FindsTouchingBoxesAndNotThoseAnUlpApart) {
  BroadPhase broad;
  const double next = std::nextafter(1.0, 2.0);
  const BoxId a = broad.add({{0, 0, 0}, {1, 1, 1}});
  const BoxId b = broad.add({{1, 1, 1}, {2, 2, 2}});
  broad.add({{next, 0, 0}, {2, 0, 0}});
  broad.update();
  ASSERT_EQ(broad.pairs().size(), 1u);
  EXPECT_EQ(broad.pairs()[0], (BoxPair{a.index, b.index}));
}

TEST(BroadPhase, RefusesWhatIsNoBox) {
  BroadPhase broad;
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const BoxId id = broad.add({{0, 0, 0}, {1, 1, 1}});
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    for (int c = 0; c < 3; ++c) {
      Aabb box{{0, 0, 0}, {1, 1, 1}};
      box.max[c] = bad;
      EXPECT_THROW(broad.add(box), InputError);
      EXPECT_THROW(broad.move(id, box), InputError);
      EXPECT_THROW(broad.move(std::vector<BoxId>{id}, std::vector<Aabb>{box}), InputError);
    }
  }
  EXPECT_THROW(broad.add({{0, 0, 1}, {1, 1, 0}}), InputError);
  EXPECT_THROW(broad.move(std::vector<BoxId>{id}, std::vector<Aabb>{}), InputError);
  EXPECT_THROW(BroadPhase({.threads = -1}), InputError);
  EXPECT_EQ(broad.size(), 1u);
}

TEST(BroadPhase, ASpanWithABadElementMovesNothingAndNamesIt) {
  BroadPhase broad;
  const std::vector<BoxId> ids = {broad.add({{0, 0, 0}, {1, 1, 1}}),
                                  broad.add({{5, 5, 5}, {6, 6, 6}})};
  std::vector<Aabb> boxes = {{{5, 5, 5}, {6, 6, 6}}, {{0, 0, 0}, {-1, 1, 1}}};
  try {
    broad.move(ids, boxes);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("element 1"), std::string::npos) << error.what();
  }
  broad.update();
  EXPECT_TRUE(broad.pairs().empty());
  boxes[1] = boxes[0];
  EXPECT_THROW(broad.move(std::vector<BoxId>{ids[0], BoxId{9, 1}}, boxes), StaleIdError);
}

TEST(BroadPhase, AnIdGoesStaleWhenItsIndexIsUsedAgain) {
  BroadPhase broad;
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  const BoxId first = broad.add(box);
  broad.add(box);
  broad.update();
  broad.remove(first);
  EXPECT_THROW(broad.remove(first), StaleIdError);
  EXPECT_NE(broad.add(box).index, first.index) << "pairs that end still name it";
  broad.update();
  EXPECT_EQ(list(broad.ended()), (Pairs{{0, 1}}));
  EXPECT_EQ(list(broad.begun()), (Pairs{{1, 2}}));
  EXPECT_NE(broad.add(box).index, first.index) << "the list of the last update names it";
  broad.update();
  const BoxId second = broad.add(box);
  EXPECT_EQ(second.index, first.index);
  EXPECT_NE(second, first);
  EXPECT_THROW(broad.box(first), StaleIdError);
  EXPECT_THROW(broad.id(77), StaleIdError);
}

/// In a block from which a box has gone a few grow to the largest doubles: extents beyond them.
TEST(BroadPhase, BoxesMayGrowToTheLargestDoubles) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  BroadPhase broad;
  std::vector<BoxId> ids;
  std::vector<Aabb> boxes;
  for (int i = 0; i < 3000; ++i) {
    boxes.push_back({{2.0 * i, 0, 0}, {2.0 * i + 1, 1, 1}});
    ids.push_back(broad.add(boxes.back()));
  }
  broad.update();
  for (std::size_t i = 0; i < 100; ++i) {
    broad.remove(ids[i]);
    if (i % 25 == 24) broad.update();
  }
  ids.erase(ids.begin(), ids.begin() + 100);
  boxes.erase(boxes.begin(), boxes.begin() + 100);
  for (std::size_t first = 0; first < 64; ++first) {
    std::vector<Aabb> grown = boxes;
    for (std::size_t i = first; i < first + 4; ++i)
      grown[i] = {{-kLargest, -kLargest, 9}, {kLargest, kLargest, 9}};
    broad.move(ids, grown);
    broad.update();
    EXPECT_EQ(broad.pairs().size(), 6u);
  }
}

TEST(BroadPhase, AnUpdateWithoutMovesLooksAtNothing) {
  BroadPhase broad;
  Chance chance(5);
  for (int i = 0; i < 500; ++i)
    broad.add(test::random_box(Habitat::Uniform, chance));
  broad.update();
  const BroadPhaseWork before = broad.work();
  const Pairs pairs = list(broad.pairs());
  broad.update();
  EXPECT_EQ(broad.work().searches_for_all, before.searches_for_all);
  EXPECT_EQ(broad.work().searches_for_movers, before.searches_for_movers);
  EXPECT_EQ(list(broad.pairs()), pairs);
  EXPECT_TRUE(broad.begun().empty());
  EXPECT_TRUE(broad.ended().empty());
}

}  // namespace
}  // namespace graze
