#include <graze/engine/world/contact_tracker.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "tests/benchmark/common/thread_clock.h"
#include "tests/benchmark/world/contestant.h"

namespace graze::benchmark {
namespace {

class Graze final : public Contestant {
 public:
  void start(const Scene& scene, const Frame& frame) override {
    world_.add({scene.ground, Pose::Identity()}, {.kind = BodyKind::Static});
    std::vector<std::shared_ptr<const BodyShape>> shapes;
    for (const Kind& kind : scene.kinds)
      shapes.push_back(share(kind.shape));
    for (std::size_t i = 0; i < frame.size(); ++i)
      ids_.push_back(world_.add({shapes[scene.bodies[i]], frame[i]}));
    step(frame);
  }

  Counts step(const Frame& frame) override {
    world_.move(ids_, frame);
    update_ = world_.update();
    Counts counts{update_.contacts.size(), 0};
    for (const BodyContact& contact : update_.contacts)
      counts.contacts += contact.manifold.size();
    return counts;
  }

  Lasting lasting() override {
    const ThreadClock clock;
    tracker_.take(world_, update_);
    Lasting result{.tracker_ms = clock.nanoseconds() * 1e-6};
    std::size_t by_features = 0, by_tracker = 0, all = 0;
    std::map<BodyPair, Told> now;
    for (std::size_t i = 0; i < update_.contacts.size(); ++i) {
      const auto& [pair, manifold] = update_.contacts[i];
      const std::span<const std::uint64_t> ids = tracker_.ids(i);
      now[pair] = {manifold, {ids.begin(), ids.end()}};
      const auto before = before_.find(pair);
      if (before == before_.end()) continue;
      for (const ShapeContact& point : manifold)
        by_features +=
            std::ranges::count(before->second.manifold, point.feature, &ShapeContact::feature);
      for (const std::uint64_t id : ids)
        by_tracker += std::ranges::count(before->second.ids, id);
      all += ids.size();
    }
    before_ = std::move(now);
    if (all == 0) return result;
    result.by_features = static_cast<double>(by_features) / static_cast<double>(all);
    result.by_tracker = static_cast<double>(by_tracker) / static_cast<double>(all);
    return result;
  }

 private:
  struct Told {
    Manifold manifold;
    std::vector<std::uint64_t> ids;
  };

  World world_;
  std::vector<BodyId> ids_;
  WorldUpdate update_;
  ContactTracker tracker_;
  std::map<BodyPair, Told> before_;
};

}  // namespace

std::unique_ptr<Contestant> make_graze() {
  return std::make_unique<Graze>();
}

}  // namespace graze::benchmark
