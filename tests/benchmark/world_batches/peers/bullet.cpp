// Bullet, compiled for double: btCollisionWorld with a btDbvtBroadphase; rayTest(), contactTest()
// and convexSweepTest(), margins of boxes 0.

#include <btBulletCollisionCommon.h>

#include "tests/benchmark/world_batches/peer.h"

static_assert(sizeof(btScalar) == sizeof(double), "compile this file with BT_USE_DOUBLE_PRECISION");

namespace graze::benchmark {
namespace {

btVector3 to_bullet(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

btTransform to_bullet(const Pose& pose) {
  const auto& r = pose.linear();
  return btTransform(
      btMatrix3x3(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
      to_bullet(pose.translation()));
}

std::unique_ptr<btConvexShape> to_bullet(const Shape& shape) {
  if (const auto* ball = shape.as<Sphere>()) return std::make_unique<btSphereShape>(ball->radius);
  auto box = std::make_unique<btBoxShape>(to_bullet(shape.as<Box>()->half_extents));
  box->setMargin(0);
  return box;
}

/// Whether anything touches.
struct AnyContact : btCollisionWorld::ContactResultCallback {
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    is_hit |= point.getDistance() <= 0;
    return 0;
  }
  bool is_hit = false;
};

class Bullet final : public BatchPeer {
 public:
  explicit Bullet(const Questions& all) : probe_(to_bullet(all.probe)) {
    for (const PlacedShape& body : all.bodies) {
      shapes_.push_back(to_bullet(body.shape));
      objects_.push_back(std::make_unique<btCollisionObject>());
      objects_.back()->setCollisionShape(shapes_.back().get());
      objects_.back()->setWorldTransform(to_bullet(body.pose));
      world_.addCollisionObject(objects_.back().get());
    }
    world_.updateAabbs();
    broadphase_.optimize();
    asked_.setCollisionShape(probe_.get());
  }
  ~Bullet() override {
    for (const auto& object : objects_)
      world_.removeCollisionObject(object.get());
  }

  std::string name() const override { return "bullet"; }

  std::optional<std::size_t> ask(Question question, const Questions& all) override {
    switch (question) {
      case Question::Rays:
        return cast_rays(all.rays);
      case Question::Touching:
        return find_touching(all.poses);
      case Question::Casts:
        return cast(all.motions);
      default:
        return std::nullopt;
    }
  }

 private:
  std::size_t cast_rays(const std::vector<Ray>& rays) {
    std::size_t hits = 0;
    for (const Ray& ray : rays) {
      const btVector3 from = to_bullet(ray.origin);
      const btVector3 to = from + to_bullet(ray.direction.normalized() * ray.max_distance);
      btCollisionWorld::ClosestRayResultCallback first(from, to);
      world_.rayTest(from, to, first);
      hits += first.hasHit();
    }
    return hits;
  }

  std::size_t find_touching(const std::vector<Pose>& poses) {
    std::size_t hits = 0;
    for (const Pose& pose : poses) {
      asked_.setWorldTransform(to_bullet(pose));
      AnyContact contact;
      world_.contactTest(&asked_, contact);
      hits += contact.is_hit;
    }
    return hits;
  }

  std::size_t cast(const std::vector<RigidMotion>& motions) {
    std::size_t hits = 0;
    for (const RigidMotion& motion : motions) {
      const btTransform from = to_bullet(motion.start());
      const btTransform to(from.getBasis(), from.getOrigin() + to_bullet(motion.shift()));
      btCollisionWorld::ClosestConvexResultCallback first(from.getOrigin(), to.getOrigin());
      world_.convexSweepTest(probe_.get(), from, to, first);
      hits += first.hasHit();
    }
    return hits;
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_{&dispatcher_, &broadphase_, &configuration_};
  std::vector<std::unique_ptr<btConvexShape>> shapes_;
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
  std::unique_ptr<btConvexShape> probe_;
  btCollisionObject asked_;
};

}  // namespace

std::unique_ptr<BatchPeer> make_bullet(const Questions& all) {
  return std::make_unique<Bullet>(all);
}

}  // namespace graze::benchmark
