// Random histories of boxes in which allocations fail. A call that throws has not happened: the
// boxes are those of before, and an update that throws is made up for by the next one. Held against
// boxes by hand, each with each, and against the ids of a broad phase in which nothing fails.

#include <graze/engine/world/broad_phase.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "tests/engine/allocations/failing_new.h"
#include "tests/engine/broad_phase/box_histories.h"

namespace graze::tests {
namespace {

using test::Chance;
using test::Habitat;
using BoxPairs = std::vector<BoxPair>;

class FailingBoxes {
 public:
  FailingBoxes(Habitat habitat, std::uint64_t seed, int threads)
      : habitat_(habitat), chance_(seed), boxes_({.threads = threads}) {}

  long calls() const { return calls_; }
  long failures() const { return failures_; }

  /// The n-th allocation from now on fails, and then each that is so many later.
  void fail_at(long n, long again) { due_ = n, again_ = again; }

  void step(int changes, int most) {
    for (int i = 0; i < changes; ++i)
      change_one(most);
    if (!ids_.empty() && chance_.one_in(3)) move_some();
    ask();
    if (chance_.one_in(5)) return;
    update();
  }

 private:
  /// Does something to the boxes on trial, again if it was thrown out of.
  template <typename Task>
  void on_trial(const Task& task) {
    constexpr int kMostInTurn = 3;  // or what needs several would never end
    for (int turn = 0;; ++turn) {
      bool has_ended = false;
      {
        const bool may_fail = due_ > calls_ && turn < kMostInTurn;
        const FailingNew armed(may_fail ? due_ - calls_ : FailingNew::kNever);
        try {
          task();
          has_ended = true;
        } catch (const std::bad_alloc&) {
          ++failures_;
        }
        calls_ += armed.calls();
      }
      if (due_ != 0 && calls_ >= due_) due_ = again_ == 0 ? 0 : calls_ + again_;
      if (has_ended) return;
      expect_as_by_hand();
    }
  }

  void expect_as_by_hand() {
    ASSERT_EQ(boxes_.size(), ids_.size());
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      ASSERT_TRUE(boxes_.contains(ids_[i]));
      const Aabb box = boxes_.box(ids_[i]);
      ASSERT_TRUE(box.min == places_[i].min && box.max == places_[i].max);
    }
  }

  void change_one(int most) {
    const std::uint32_t what = chance_.below(4);
    const auto count = static_cast<std::uint32_t>(ids_.size());
    if (ids_.empty() || (what == 0 && static_cast<int>(count) < most)) {
      const Aabb box = test::random_box(habitat_, chance_);
      BoxId id;
      on_trial([&] { id = boxes_.add(box); });
      ids_.push_back(id), places_.push_back(box);
      ASSERT_EQ(id, unspoilt_.add(box));
      return;
    }
    const std::uint32_t i = chance_.below(count);
    if (what == 1 && 2 * static_cast<int>(count) > most) {
      on_trial([&] { boxes_.remove(ids_[i]); });
      unspoilt_.remove(ids_[i]);
      ids_.erase(ids_.begin() + i), places_.erase(places_.begin() + i);
    } else {
      const Aabb box = chance_.one_in(3) ? test::random_box(habitat_, chance_)
                                         : test::stepped(places_[i], habitat_, chance_);
      on_trial([&] { boxes_.move(ids_[i], box); });
      unspoilt_.move(ids_[i], box);
      places_[i] = box;
    }
  }

  /// A few, or all, in any order.
  void move_some() {
    std::vector<BoxId> ids;
    std::vector<Aabb> places;
    const std::uint32_t one_in = chance_.one_in(2) ? 1 : 1 + chance_.below(30);
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      if (!chance_.one_in(one_in)) continue;
      ids.push_back(ids_[i]);
      places.push_back(test::stepped(places_[i], habitat_, chance_));
    }
    if (chance_.one_in(2))
      std::reverse(ids.begin(), ids.end()), std::reverse(places.begin(), places.end());
    on_trial([&] { boxes_.move(ids, places); });
    unspoilt_.move(ids, places);
    std::map<BoxId, Aabb> to;
    for (std::size_t i = 0; i < ids.size(); ++i)
      to[ids[i]] = places[i];
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      if (to.contains(ids_[i])) places_[i] = to[ids_[i]];
    }
  }

  void ask() {
    const Aabb box = test::random_box(habitat_, chance_);
    std::vector<std::uint32_t> found, expected;
    on_trial([&] {
      found.clear();
      boxes_.find_overlapping(box, found);
    });
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      if (test::share_point(box, places_[i])) expected.push_back(ids_[i].index);
    }
    std::sort(found.begin(), found.end()), std::sort(expected.begin(), expected.end());
    ASSERT_EQ(found, expected);
  }

  void update() {
    BoxPairs begun, ended, all;
    on_trial([&] { boxes_.update(); });
    on_trial([&] { begun.assign(boxes_.begun().begin(), boxes_.begun().end()); });
    on_trial([&] { ended.assign(boxes_.ended().begin(), boxes_.ended().end()); });
    on_trial([&] { all.assign(boxes_.sorted_pairs().begin(), boxes_.sorted_pairs().end()); });
    unspoilt_.update();
    const BoxPairs now = pairs_by_hand();
    ASSERT_EQ(all, now);
    ASSERT_EQ(begun, difference(now, before_));
    ASSERT_EQ(ended, difference(before_, now));
    before_ = now;
  }

  BoxPairs pairs_by_hand() const {
    BoxPairs pairs;
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      for (std::size_t j = i + 1; j < ids_.size(); ++j) {
        if (!test::share_point(places_[i], places_[j])) continue;
        pairs.push_back(
            {std::min(ids_[i].index, ids_[j].index), std::max(ids_[i].index, ids_[j].index)});
      }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  static BoxPairs difference(const BoxPairs& s, const BoxPairs& t) {
    BoxPairs left;
    std::set_difference(s.begin(), s.end(), t.begin(), t.end(), std::back_inserter(left));
    return left;
  }

  Habitat habitat_;
  Chance chance_;
  BroadPhase boxes_, unspoilt_;
  std::vector<BoxId> ids_;
  std::vector<Aabb> places_;
  BoxPairs before_;
  long calls_ = 0, due_ = 0, again_ = 0, failures_ = 0;
};

struct BoxHistory {
  Habitat habitat;
  std::uint64_t seed;
  int most;  // boxes
  int threads = 1;
};

/// Returns how many allocations the history has.
long play_boxes(const BoxHistory& history, long n, long again, long& failures) {
  FailingBoxes boxes(history.habitat, history.seed, history.threads);
  boxes.fail_at(n, again);
  const int steps = 14;
  for (int step = 0; step < steps && !testing::Test::HasFailure(); ++step)
    boxes.step(step == 0 ? history.most : 1 + history.most / (step % 3 == 0 ? 4 : 24),
               history.most);
  failures += boxes.failures();
  return boxes.calls();
}

void fail_allocations_of_boxes(const BoxHistory& history, long most) {
  long none = 0;
  const long count = play_boxes(history, 0, 0, none);
  EXPECT_EQ(none, 0);
  EXPECT_GT(count, 50);
  long failures = 0;
  for (long n = 1; n <= count; n = next_failure(n, count, most)) {
    SCOPED_TRACE("allocation " + std::to_string(n) + ", seed " + std::to_string(history.seed));
    const long before = live_blocks();
    play_boxes(history, n, n % 3 == 0 ? 1 + n % 7 : 0, failures);
    EXPECT_EQ(live_blocks(), before);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(failures, 10);
}

TEST(Allocations, OfBoxesMayFail) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    fail_allocations_of_boxes({Habitat::Uniform, seed, 40}, 60);
    fail_allocations_of_boxes({Habitat::Sizes, seed, 300}, 20);
  }
}

TEST(AllocationsSlow, OfBoxesMayFail) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    for (const Habitat habitat : test::kHabitats) {
      fail_allocations_of_boxes({habitat, seed, 40}, 1000000);
      fail_allocations_of_boxes({habitat, seed, 400}, 300);
      if (testing::Test::HasFailure()) return;
    }
  }
  fail_allocations_of_boxes({Habitat::Uniform, 1, 5000, 2}, 40);
}

}  // namespace
}  // namespace graze::tests
