#include <graze/engine/compare/run/shared_loads.h>

#include <algorithm>
#include <mutex>
#include <utility>

namespace graze::compare {
namespace {

// Each pair that is kept keeps a process for each thread that has asked about it.
constexpr std::size_t kMostKept = 4;

/// This is the share of one of those who have loaded a pair together.
class Share : public LoadedPair {
 public:
  explicit Share(std::shared_ptr<const LoadedPair> pair) : pair_(std::move(pair)) {}
  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    return pair_->answer(question, pose_a, pose_b);
  }
  TimedAnswer timed_answer(const Question& question, const Pose& pose_a,
                           const Pose& pose_b) const override {
    return pair_->timed_answer(question, pose_a, pose_b);
  }

 private:
  std::shared_ptr<const LoadedPair> pair_;
};

class SharingEngine : public Engine {
 public:
  explicit SharingEngine(const Engine& engine) : engine_(engine) {}

  CaseWitness name() const override { return engine_.name(); }
  std::optional<std::vector<Ask>> questions() const override { return engine_.questions(); }
  std::unique_ptr<LoadedShapes> load_shapes(std::span<const Shape> shapes) const override {
    return engine_.load_shapes(shapes);
  }
  bool answers_scenes() const override { return engine_.answers_scenes(); }
  std::unique_ptr<Engine> alone() const override { return engine_.alone(); }

  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    const std::lock_guard lock(mutex_);
    auto at = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& each) {
      return each.mesh_a == mesh_a && each.mesh_b == mesh_b;
    });
    if (at == kept_.end()) {
      Kept loaded{mesh_a, mesh_b, engine_.load(mesh_a, mesh_b)};
      if (kept_.size() == kMostKept) kept_.pop_back();
      at = kept_.insert(kept_.begin(), std::move(loaded));
    } else {
      std::rotate(kept_.begin(), at, at + 1);
      at = kept_.begin();
    }
    return std::make_unique<Share>(at->pair);
  }

 private:
  struct Kept {
    Mesh mesh_a;
    Mesh mesh_b;
    std::shared_ptr<const LoadedPair> pair;
  };

  const Engine& engine_;
  mutable std::mutex mutex_;
  mutable std::vector<Kept> kept_;  ///< begins with the one that was asked for last
};

}  // namespace

SharedLoads::SharedLoads(std::span<const EngineEntry> engines) {
  for (const EngineEntry& entry : engines) {
    engines_.push_back({entry.name, nullptr, entry.is_users_own});
    if (entry.engine != nullptr)
      engines_.back().engine = std::make_unique<SharingEngine>(*entry.engine);
  }
}

}  // namespace graze::compare
