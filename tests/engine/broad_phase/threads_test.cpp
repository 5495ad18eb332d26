// One broad phase whose work many threads share. Under ThreadSanitizer these are threads that it
// can follow (bvh/box_set/store/fork.h), and the kernels are compiled for it: whatever two of them
// may touch at once is seen.

#include <graze/engine/world/broad_phase.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/engine/broad_phase/box_histories.h"

namespace graze {
namespace {

using test::Chance;
using test::Habitat;

// Enough for chunks of every kind of work, and for a sort that forks.
constexpr std::uint32_t kCount = 9000;

/// The same boxes twice: one broad phase with many threads, one with a single one.
class Both {
 public:
  Both() {
    for (std::uint32_t i = 0; i < kCount; ++i) {
      boxes_.push_back(random_box());
      ids_.push_back(many_.add(boxes_.back()));
      alone_.add(boxes_.back());
    }
  }
  void expect_same() {
    many_.update();
    alone_.update();
    EXPECT_FALSE(many_.pairs().empty());
    EXPECT_TRUE(same(many_.pairs(), alone_.pairs()));
    EXPECT_TRUE(same(many_.begun(), alone_.begun()));
    EXPECT_TRUE(same(many_.ended(), alone_.ended()));
  }
  /// One box in `share`, in ascending order.
  void step(std::uint32_t share) {
    choose(share);
    move_chosen();
  }
  void step_in_descending_order(std::uint32_t share) {
    choose(share);
    std::reverse(chosen_.begin(), chosen_.end());
    std::reverse(places_.begin(), places_.end());
    move_chosen();
  }
  void replace(std::uint32_t count) {
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t i = chance_.below(kCount);
      boxes_[i] = random_box();
      many_.remove(ids_[i]);
      alone_.remove(ids_[i]);
      ids_[i] = many_.add(boxes_[i]);
      EXPECT_EQ(alone_.add(boxes_[i]), ids_[i]);
    }
  }
  const BroadPhaseWork& work() const { return many_.work(); }

 private:
  static bool same(std::span<const BoxPair> s, std::span<const BoxPair> t) {
    return std::equal(s.begin(), s.end(), t.begin(), t.end());
  }
  void choose(std::uint32_t share) {
    chosen_.clear(), places_.clear();
    for (std::uint32_t i = 0; i < kCount; i += share) {
      boxes_[i] = test::stepped(boxes_[i], Habitat::Uniform, chance_);
      chosen_.push_back(ids_[i]);
      places_.push_back(boxes_[i]);
    }
  }
  void move_chosen() {
    many_.move(chosen_, places_);
    alone_.move(chosen_, places_);
  }
  Aabb random_box() {
    Aabb box = test::random_box(Habitat::Uniform, chance_);
    box.min *= 6;
    box.max = box.min + Eigen::Vector3d::Constant(2);
    return box;
  }

  Chance chance_{21};
  BroadPhase many_{{.threads = 4}}, alone_;
  std::vector<Aabb> boxes_;
  std::vector<BoxId> ids_;
  std::vector<BoxId> chosen_;
  std::vector<Aabb> places_;
};

TEST(BroadPhaseThreads, ShareEveryKindOfWork) {
  Both both;
  both.expect_same();  // a sort, and a search for all pairs
  both.step(1);        // of all, in order
  both.expect_same();
  both.step(3);  // of some, ascending
  both.expect_same();
  both.step_in_descending_order(2);
  both.expect_same();
  both.step(100);  // of few
  both.expect_same();
  both.replace(kCount / 8);
  both.expect_same();
  EXPECT_GE(both.work().searches_for_all, 4u);
  EXPECT_GE(both.work().sorts, 1u);
}

}  // namespace
}  // namespace graze
