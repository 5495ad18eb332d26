// A world that runs on and on: it stays right, and needs no more memory than in the beginning.

#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "tests/engine/body_world/allocations.h"
#include "tests/engine/broad_phase/box_histories.h"
#include "tests/engine/histories/history.h"

namespace graze::tests {
namespace {

struct Body {
  std::uint32_t shape;
  Pose pose;
};

/// Bodies that come and go; each year is like the one before, down to the last bit.
class Village {
 public:
  static constexpr int kYear = 500;  // steps

  Village() : palette_(palette_of(Setting::Crowd)) {
    for (const Shape& shape : palette_)
      shared_.push_back(share(shape));
    for (int i = 0; i < 18; ++i)
      add();
  }

  WorldUpdate step(int day) {
    if (day % 3 == 0) replace();
    for (int i = 0; i < 4; ++i)
      move(day == 0 || i == 0);
    if (day % 7 == 0) world_.set_filter(pick(), {.category = 1u << chance_.below(2)});
    if (day % 11 == 0) set_shape();
    if (day % 13 == 0) exclude(ids_[0], pick());
    return world_.update();
  }

  /// Again all bodies as they were at the beginning of a year.
  void begin_year() {
    while (!ids_.empty()) {
      world_.remove(ids_.back());
      ids_.pop_back();
    }
    bodies_.clear();
    excluded_.clear();
    world_.update();
    chance_ = test::Chance(4);
    for (int i = 0; i < 18; ++i)
      add();
  }

  std::vector<BodyPair> brute_force() const {
    std::vector<BodyPair> pairs;
    for (auto s = bodies_.begin(); s != bodies_.end(); ++s) {
      for (auto t = std::next(s); t != bodies_.end(); ++t) {
        if (lets_pass(world_.filter(s->first), world_.filter(t->first)) &&
            !is_excluded({s->first, t->first}) &&
            intersects({palette_[s->second.shape], s->second.pose},
                       {palette_[t->second.shape], t->second.pose}))
          pairs.push_back({s->first, t->first});
      }
    }
    return pairs;
  }

  const World& world() const { return world_; }

 private:
  bool is_excluded(const BodyPair& pair) const {
    return std::find(excluded_.begin(), excluded_.end(), pair) != excluded_.end();
  }
  void exclude(const BodyId& a, const BodyId& b) {
    world_.exclude(a, b);
    excluded_.push_back({std::min(a, b), std::max(a, b)});
  }
  Pose random_pose() {
    Pose pose = Pose::Identity();
    for (int k = 0; k < 3; ++k)
      pose.matrix()(k, 3) = chance_.between(-3, 3);
    return pose;
  }
  void add() {
    const std::uint32_t shape = chance_.below(static_cast<std::uint32_t>(palette_.size()) - 2);
    const Pose pose = random_pose();
    const BodyId id = world_.add({shared_[shape], pose});
    ids_.push_back(id);
    bodies_[id] = {shape, pose};
  }
  BodyId pick() { return ids_[1 + chance_.below(static_cast<std::uint32_t>(ids_.size()) - 1)]; }
  void replace() {
    const BodyId id = ids_.back();
    world_.remove(id);
    ids_.pop_back();
    bodies_.erase(id);
    std::erase_if(excluded_, [&](const BodyPair& pair) { return pair.a == id || pair.b == id; });
    add();
    std::rotate(ids_.begin() + 1, ids_.end() - 1, ids_.end());
  }
  void move(bool is_far) {
    const BodyId id = pick();
    Pose pose = bodies_[id].pose;
    for (int k = 0; k < 3; ++k)
      pose.matrix()(k, 3) =
          is_far ? chance_.between(-3, 3) : pose.matrix()(k, 3) + chance_.between(-0.01, 0.01);
    bodies_[id].pose = pose;
    world_.move(id, pose);
  }
  void set_shape() {
    const BodyId id = pick();
    bodies_[id].shape = chance_.below(static_cast<std::uint32_t>(palette_.size()) - 2);
    world_.set_shape(id, shared_[bodies_[id].shape]);
  }

  World world_;
  std::vector<Shape> palette_;
  std::vector<std::shared_ptr<const BodyShape>> shared_;
  std::vector<BodyId> ids_;
  std::map<BodyId, Body> bodies_;
  std::vector<BodyPair> excluded_;
  test::Chance chance_{1};
};

void soak(int years) {
  Village village;
  std::size_t bytes = 0;
  std::uint64_t told = 0, told_in_second_year = 0;
  for (int year = 0; year < years; ++year) {
    village.begin_year();
    std::uint64_t told_now = 0;
    for (int day = 0; day < Village::kYear; ++day) {
      const WorldUpdate update = village.step(day);
      told_now = told_now * 31 + update.begun.size() + 3 * update.ended.size() +
                 5 * update.moved.size() + 7 * update.contacts.size();
      if (day == 77 + year % 400) {
        ASSERT_EQ(village.world().pairs(), village.brute_force()) << year;
      }
    }
    told += told_now;
    if (year == 1) told_in_second_year = told_now;
    if (year > 1) {
      ASSERT_EQ(told_now, told_in_second_year) << "year " << year;
    }
    if (year == 9) bytes = allocated_bytes();
  }
  EXPECT_NE(told, 0u);
  // A box's generations are two bytes: an index of the broad phase is used up by 32,768 boxes.
  EXPECT_LE(allocated_bytes(), bytes + 4096);
}

TEST(Soak, TwentyThousandStepsInConstantMemory) {
  soak(40);
}

TEST(SoakSlow, AMillionStepsInConstantMemory) {
  soak(2000);
}

}  // namespace
}  // namespace graze::tests
