#include <graze/engine/world/world.h>

#include <algorithm>
#include <map>

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
    const WorldUpdate update = world_.update();
    contacts_ = update.contacts;
    Counts counts{contacts_.size(), 0};
    for (const BodyContact& contact : contacts_)
      counts.contacts += contact.manifold.size();
    return counts;
  }

  double kept_features() override {
    std::size_t kept = 0, all = 0;
    std::map<BodyPair, Manifold> now;
    for (const BodyContact& contact : contacts_) {
      now[contact.pair] = contact.manifold;
      const auto before = before_.find(contact.pair);
      if (before == before_.end()) continue;
      for (const ShapeContact& point : contact.manifold) {
        kept += std::any_of(before->second.begin(), before->second.end(),
                            [&](const ShapeContact& c) { return c.feature == point.feature; });
        ++all;
      }
    }
    before_ = std::move(now);
    return all == 0 ? -1 : static_cast<double>(kept) / static_cast<double>(all);
  }

 private:
  World world_;
  std::vector<BodyId> ids_;
  std::span<const BodyContact> contacts_;
  std::map<BodyPair, Manifold> before_;
};

}  // namespace

std::unique_ptr<Contestant> make_graze() {
  return std::make_unique<Graze>();
}

}  // namespace graze::benchmark
