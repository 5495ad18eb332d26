// Bullet's two trees and its sweep along three axes. Both keep pairs of enlarged or quantised
// boxes: who wants those that overlap tests each.

#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include "tests/benchmark/broad_phase/peers/peers.h"

namespace graze::benchmark {
namespace {

class Bullet : public Contestant {
 public:
  explicit Bullet(bool sweeps) : sweeps_(sweeps) {}
  ~Bullet() override {
    for (btBroadphaseProxy* proxy : proxies_)
      broad_->destroyProxy(proxy, nullptr);
  }

  void start(std::span<const Aabb> boxes) override {
    if (sweeps_) {
      btVector3 low(0, 0, 0), high(0, 0, 0);
      for (const Aabb& box : boxes) {
        low.setMin(vector(box.min)), high.setMax(vector(box.max));
      }
      const btVector3 room = 0.1 * (high - low) + btVector3(10, 10, 10);
      broad_ = std::make_unique<bt32BitAxisSweep3>(low - room, high + room,
                                                   static_cast<unsigned>(boxes.size() + 10));
    } else {
      broad_ = std::make_unique<btDbvtBroadphase>();
    }
    for (std::size_t i = 0; i < boxes.size(); ++i)
      proxies_.push_back(proxy(i, boxes[i]));
    broad_->calculateOverlappingPairs(nullptr);
  }

  std::span<const BoxPair> step(std::span<const Aabb> boxes,
                                std::span<const std::uint32_t> moved) override {
    for (const std::uint32_t i : moved)
      broad_->setAabb(proxies_[i], vector(boxes[i].min), vector(boxes[i].max), nullptr);
    return find(boxes);
  }

  std::span<const BoxPair> replace(std::span<const Aabb> boxes,
                                   std::span<const std::uint32_t> replaced) override {
    for (const std::uint32_t i : replaced) {
      broad_->destroyProxy(proxies_[i], nullptr);
      proxies_[i] = proxy(i, boxes[i]);
    }
    return find(boxes);
  }

 private:
  std::span<const BoxPair> find(std::span<const Aabb> boxes) {
    broad_->calculateOverlappingPairs(nullptr);
    pairs_.clear();
    const btBroadphasePairArray& found =
        broad_->getOverlappingPairCache()->getOverlappingPairArray();
    for (int k = 0; k < found.size(); ++k) {
      const std::uint32_t s = index(found[k].m_pProxy0), t = index(found[k].m_pProxy1);
      if (share_point(boxes[s], boxes[t])) pairs_.push_back(ordered_pair(s, t));
    }
    return pairs_;
  }
  btBroadphaseProxy* proxy(std::size_t i, const Aabb& box) {
    return broad_->createProxy(vector(box.min), vector(box.max), 0, reinterpret_cast<void*>(i), 1,
                               1, nullptr);
  }
  static btVector3 vector(const Eigen::Vector3d& p) { return {p[0], p[1], p[2]}; }
  static std::uint32_t index(const btBroadphaseProxy* proxy) {
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(proxy->m_clientObject));
  }

  bool sweeps_;
  std::unique_ptr<btBroadphaseInterface> broad_;
  std::vector<btBroadphaseProxy*> proxies_;
  std::vector<BoxPair> pairs_;
};

}  // namespace

void add_bullet(std::vector<Entry>& entries) {
  entries.push_back({"Bullet DBVT", [] { return std::make_unique<Bullet>(false); }});
  entries.push_back({"Bullet axis sweep", [] { return std::make_unique<Bullet>(true); }});
}

}  // namespace graze::benchmark
