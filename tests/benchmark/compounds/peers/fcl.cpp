// FCL, which has no compounds: an object for each part in a manager with a dynamic tree of boxes,
// asked about one object; of a body of parts that moves, too, each object is moved and its tree
// brought up to date.

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/narrowphase/collision.h>

#include "tests/benchmark/compounds/peers/fcl_parts.h"

namespace graze::benchmark {

namespace {

bool on_pair(fcl::CollisionObjectd* s, fcl::CollisionObjectd* t, void* data) {
  fcl::CollisionResultd result;
  fcl::collide(s, t, fcl::CollisionRequestd(), result);
  *static_cast<bool*>(data) = result.isCollision();
  return result.isCollision();
}

/// Parts as objects, in a manager.
struct Objects {
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> list;
  std::unique_ptr<fcl::DynamicAABBTreeCollisionManagerd> manager;

  void build(const Parts& parts) {
    manager.reset(), list.clear();
    manager = std::make_unique<fcl::DynamicAABBTreeCollisionManagerd>();
    for (const PlacedShape& part : parts) {
      list.push_back(
          std::make_unique<fcl::CollisionObjectd>(to_fcl(part.shape), to_fcl(part.pose)));
      manager->registerObject(list.back().get());
    }
    manager->setup();
  }
};

class Fcl final : public BodyContestant {
 public:
  explicit Fcl(const Parts& parts) : parts_(parts) {}
  std::string name() const override { return "fcl"; }
  void build() override { body_.build(parts_); }
  void take(const Asked& asked) override {
    asked_parts_ = asked.parts;
    asked_.build(asked.parts);
  }
  bool touches(const Pose& pose) override {
    for (std::size_t i = 0; i < asked_parts_.size(); ++i) {
      asked_.list[i]->setTransform(to_fcl(Pose(pose * asked_parts_[i].pose)));
      asked_.list[i]->computeAABB();
    }
    bool is_hit = false;
    if (asked_parts_.size() == 1) {
      body_.manager->collide(asked_.list[0].get(), &is_hit, on_pair);
      return is_hit;
    }
    asked_.manager->update();
    body_.manager->collide(asked_.manager.get(), &is_hit, on_pair);
    return is_hit;
  }

 private:
  const Parts& parts_;
  Objects body_, asked_;
  Parts asked_parts_;
};

}  // namespace

void add_fcl(const Parts& parts, Contestants& contestants) {
  contestants.push_back(std::make_unique<Fcl>(parts));
}

}  // namespace graze::benchmark
