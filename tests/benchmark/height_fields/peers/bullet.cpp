// Bullet, compiled for double: a btHeightfieldTerrainShape of the same floats, with its diagonals
// the same way and its accelerator for rays; performDiscreteCollisionDetection() of bodies that
// meet the ground alone, without margins.

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <btBulletCollisionCommon.h>

#include <algorithm>

#include "tests/benchmark/height_fields/contestant.h"

static_assert(sizeof(btScalar) == sizeof(double), "compile this file with BT_USE_DOUBLE_PRECISION");

namespace graze::benchmark {

namespace {

btVector3 vector(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

btTransform transform(const Pose& pose) {
  const auto& r = pose.linear();
  return btTransform(
      btMatrix3x3(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
      vector(pose.translation()));
}

class Bullet final : public FieldContestant {
 public:
  ~Bullet() override { clear(); }
  std::string name() const override { return "bullet"; }

  std::size_t build(const Terrain& terrain) override {
    clear();
    heights_ = terrain.heights;
    const auto [low, high] = std::minmax_element(heights_.begin(), heights_.end());
    const int side = static_cast<int>(terrain.side);
    field_ = std::make_unique<btHeightfieldTerrainShape>(side, side, heights_.data(), *low, *high,
                                                         2, false);
    field_->setMargin(0);
    field_->buildAccelerator();
    // Its frame's origin is in the middle of its box.
    middle_ = Eigen::Vector3d((terrain.side - 1) / 2.0, (terrain.side - 1) / 2.0,
                              (static_cast<double>(*low) + static_cast<double>(*high)) / 2);
    return 0;
  }

  void place(const Terrain& terrain) override {
    ground_ = std::make_unique<btCollisionObject>();
    ground_->setCollisionShape(field_.get());
    ground_->setWorldTransform(btTransform(btMatrix3x3::getIdentity(), vector(middle_)));
    ground_->setCollisionFlags(btCollisionObject::CF_STATIC_OBJECT);
    world_.addCollisionObject(ground_.get(), btBroadphaseProxy::StaticFilter,
                              btBroadphaseProxy::DefaultFilter);
    for (const Shape& shape : terrain.bodies) {
      if (const auto* ball = shape.as<Sphere>()) {
        shapes_.push_back(std::make_unique<btSphereShape>(ball->radius));
      } else {
        shapes_.push_back(std::make_unique<btBoxShape>(vector(shape.as<Box>()->half_extents)));
        shapes_.back()->setMargin(0);
      }
      objects_.push_back(std::make_unique<btCollisionObject>());
      objects_.back()->setCollisionShape(shapes_.back().get());
      world_.addCollisionObject(objects_.back().get(), btBroadphaseProxy::DefaultFilter,
                                btBroadphaseProxy::StaticFilter);
      objects_.back()->setCollisionFlags(0);
    }
    step(terrain.frames[0]);
  }

  std::size_t step(const std::vector<Pose>& frame) override {
    for (std::size_t i = 0; i < frame.size(); ++i)
      objects_[i]->setWorldTransform(transform(frame[i]));
    world_.performDiscreteCollisionDetection();
    std::size_t touching = 0;
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i)
      touching += dispatcher_.getManifoldByIndexInternal(i)->getNumContacts() > 0;
    return touching;
  }

  std::size_t cast(std::span<const Ray> rays) override {
    std::size_t hits = 0;
    for (const Ray& ray : rays) {
      const btVector3 from = vector(ray.origin);
      const btVector3 to = vector(ray.origin + ray.direction);
      btCollisionWorld::ClosestRayResultCallback first(from, to);
      btCollisionWorld::rayTestSingle(btTransform(btMatrix3x3::getIdentity(), from),
                                      btTransform(btMatrix3x3::getIdentity(), to), ground_.get(),
                                      field_.get(), ground_->getWorldTransform(), first);
      hits += first.hasHit();
    }
    return hits;
  }

 private:
  void clear() {
    for (const auto& object : objects_)
      world_.removeCollisionObject(object.get());
    if (ground_) world_.removeCollisionObject(ground_.get());
    objects_.clear(), shapes_.clear(), ground_.reset();
  }

  std::vector<float> heights_;
  Eigen::Vector3d middle_;
  std::unique_ptr<btHeightfieldTerrainShape> field_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_{&dispatcher_, &broadphase_, &configuration_};
  std::unique_ptr<btCollisionObject> ground_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
};

}  // namespace

std::unique_ptr<FieldContestant> make_bullet() {
  return std::make_unique<Bullet>();
}

}  // namespace graze::benchmark
