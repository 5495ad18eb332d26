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
    } else {
      for (const std::uint32_t i : moved)
        broad_.move(ids_[i], boxes[i]);
    }
    broad_.update();
    return broad_.pairs();
  }

 private:
  BroadPhase broad_;
  std::vector<BoxId> ids_;
};

}  // namespace

std::unique_ptr<Contestant> make_graze(int threads) {
  return std::make_unique<Graze>(threads);
}

}  // namespace graze::benchmark
