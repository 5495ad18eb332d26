// FCL's dynamic trees of boxes. An object at the origin takes the box of its geometry as it is, so
// that no coordinate is rounded.

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree_array.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision_object.h>

#include "tests/benchmark/broad_phase/peers/peers.h"

namespace graze::benchmark {
namespace {

template <typename S, typename Manager>
class Fcl : public Contestant {
 public:
  void start(std::span<const Aabb> boxes) override {
    for (const Aabb& box : boxes) {
      geometries_.push_back(std::make_shared<fcl::Box<S>>(1, 1, 1));
      objects_.push_back(std::make_unique<fcl::CollisionObject<S>>(geometries_.back()));
      objects_.back()->setUserData(reinterpret_cast<void*>(objects_.size() - 1));
      place(objects_.size() - 1, box);
      pointers_.push_back(objects_.back().get());
    }
    manager_.registerObjects(pointers_);
    manager_.setup();
  }

  std::span<const BoxPair> step(std::span<const Aabb> boxes,
                                std::span<const std::uint32_t> moved) override {
    movers_.clear();
    for (const std::uint32_t i : moved) {
      place(i, boxes[i]);
      movers_.push_back(pointers_[i]);
    }
    if (moved.size() == boxes.size()) {
      manager_.update();
    } else {
      manager_.update(movers_);
    }
    return find();
  }

  /// To the manager it is all one which object comes where one has gone.
  std::span<const BoxPair> replace(std::span<const Aabb> boxes,
                                   std::span<const std::uint32_t> replaced) override {
    for (const std::uint32_t i : replaced) {
      manager_.unregisterObject(pointers_[i]);
      place(i, boxes[i]);
      manager_.registerObject(pointers_[i]);
    }
    manager_.setup();
    return find();
  }

 private:
  std::span<const BoxPair> find() {
    pairs_.clear();
    manager_.collide(
        &pairs_, [](fcl::CollisionObject<S>* s, fcl::CollisionObject<S>* t, void* pairs) {
          static_cast<std::vector<BoxPair>*>(pairs)->push_back(ordered_pair(index(s), index(t)));
          return false;
        });
    return pairs_;
  }
  static std::uint32_t index(const fcl::CollisionObject<S>* object) {
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(object->getUserData()));
  }
  void place(std::size_t i, const Aabb& box) {
    fcl::AABB<S>& local = geometries_[i]->aabb_local;
    for (int c = 0; c < 3; ++c) {
      local.min_[c] = static_cast<S>(box.min[c]);
      local.max_[c] = static_cast<S>(box.max[c]);
    }
    objects_[i]->computeAABB();
  }

  std::vector<std::shared_ptr<fcl::Box<S>>> geometries_;
  std::vector<std::unique_ptr<fcl::CollisionObject<S>>> objects_;
  std::vector<fcl::CollisionObject<S>*> pointers_, movers_;
  Manager manager_;
  std::vector<BoxPair> pairs_;
};

}  // namespace

void add_fcl(std::vector<Entry>& entries) {
  entries.push_back(
      {"FCL tree, float",
       [] { return std::make_unique<Fcl<float, fcl::DynamicAABBTreeCollisionManager<float>>>(); }});
  entries.push_back(
      {"FCL tree, double", [] {
         return std::make_unique<Fcl<double, fcl::DynamicAABBTreeCollisionManager<double>>>();
       }});
}

}  // namespace graze::benchmark
