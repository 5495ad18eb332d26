#include "tests/benchmark/broad_phase/graze_contestant.h"

#include <graze/engine/world/broad_phase.h>

namespace graze::benchmark {
namespace {

class Graze : public Contestant {
 public:
  explicit Graze(int threads) : broad_({.threads = threads}) {}

  void start(std::span<const Aabb> boxes) override {
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      ids_.push_back(broad_.add(boxes[i]));
      note_number(i);
    }
    broad_.update();
  }

  std::span<const BoxPair> step(std::span<const Aabb> boxes,
                                std::span<const std::uint32_t> moved) override {
    if (moved.size() == boxes.size()) {
      broad_.move(ids_, boxes);
    } else if (moved.size() > boxes.size() / kMany) {
      moved_ids_.clear(), moved_boxes_.clear();
      for (const std::uint32_t i : moved)
        moved_ids_.push_back(ids_[i]), moved_boxes_.push_back(boxes[i]);
      broad_.move(moved_ids_, moved_boxes_);
    } else {
      for (const std::uint32_t i : moved)
        broad_.move(ids_[i], boxes[i]);
    }
    broad_.update();
    return broad_.pairs();
  }

  std::span<const BoxPair> replace(std::span<const Aabb> boxes,
                                   std::span<const std::uint32_t> replaced) override {
    for (const std::uint32_t i : replaced) {
      broad_.remove(ids_[i]);
      ids_[i] = broad_.add(boxes[i]);
      note_number(i);
    }
    broad_.update();
    return broad_.pairs();
  }

  std::uint32_t number(std::uint32_t name) const override { return number_[name]; }

  std::size_t bytes() const override { return broad_.bytes_for_boxes(); }

 private:
  static constexpr std::size_t kMany = 16;  // of so many boxes one: a span of them is cheaper

  void note_number(std::uint32_t i) {
    const std::uint32_t index = ids_[i].index;
    if (index >= number_.size()) number_.resize(index + std::size_t{1});
    number_[index] = i;
  }

  BroadPhase broad_;
  std::vector<BoxId> ids_, moved_ids_;
  std::vector<Aabb> moved_boxes_;
  std::vector<std::uint32_t> number_;  // by index
};

}  // namespace

std::unique_ptr<Contestant> make_graze(int threads) {
  return std::make_unique<Graze>(threads);
}

}  // namespace graze::benchmark
