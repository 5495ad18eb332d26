#include "tests/benchmark/broad_phase/graze_contestant.h"

#include <graze/engine/world/broad_phase.h>

namespace graze::benchmark {
namespace {

class Graze : public Contestant {
 public:
  explicit Graze(int threads) : broad_({.threads = threads}) {}

  void start(std::span<const Aabb> boxes) override {
    for (const Aabb& box : boxes)
      ids_.push_back(broad_.add(box));
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

  std::size_t bytes() const override { return broad_.bytes_for_boxes(); }

 private:
  static constexpr std::size_t kMany = 16;  // of so many boxes one: a span of them is cheaper

  BroadPhase broad_;
  std::vector<BoxId> ids_, moved_ids_;
  std::vector<Aabb> moved_boxes_;
};

}  // namespace

std::unique_ptr<Contestant> make_graze(int threads) {
  return std::make_unique<Graze>(threads);
}

}  // namespace graze::benchmark
