// Bullet, compiled for double: a btCompoundShape with its dynamic tree, without margins but for
// balls and capsules, which are nothing else; asked by contactPairTest(), which goes through all
// pairs of parts near each other.

#include <btBulletCollisionCommon.h>

#include "tests/benchmark/compounds/contestant.h"

static_assert(sizeof(btScalar) == sizeof(double), "compile this file with BT_USE_DOUBLE_PRECISION");

namespace graze::benchmark {

namespace {

btTransform transform(const Pose& pose) {
  const auto& r = pose.linear();
  const Eigen::Vector3d t = pose.translation();
  return btTransform(
      btMatrix3x3(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
      btVector3(t.x(), t.y(), t.z()));
}

std::unique_ptr<btCollisionShape> converted(const Shape& shape) {
  if (const auto* ball = shape.as<Sphere>()) return std::make_unique<btSphereShape>(ball->radius);
  if (const auto* capsule = shape.as<Capsule>())
    return std::make_unique<btCapsuleShapeZ>(capsule->radius, 2 * capsule->half_length);
  const Eigen::Vector3d half = shape.as<Box>()->half_extents;
  auto box = std::make_unique<btBoxShape>(btVector3(half.x(), half.y(), half.z()));
  box->setMargin(0);
  return box;
}

/// One shape, or a compound of several.
struct Body {
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  std::unique_ptr<btCompoundShape> compound;
  btCollisionObject object;

  void build(const Parts& parts) {
    compound.reset(), shapes.clear();
    for (const PlacedShape& part : parts)
      shapes.push_back(converted(part.shape));
    object.setCollisionShape(shapes[0].get());
    if (parts.size() == 1) return;
    compound = std::make_unique<btCompoundShape>(true, static_cast<int>(parts.size()));
    compound->setMargin(0);
    for (std::size_t i = 0; i < parts.size(); ++i)
      compound->addChildShape(transform(parts[i].pose), shapes[i].get());
    object.setCollisionShape(compound.get());
  }
};

struct AnyContact final : btCollisionWorld::ContactResultCallback {
  bool is_hit = false;
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    is_hit |= point.getDistance() <= 0;
    return 0;
  }
};

class Bullet final : public BodyContestant {
 public:
  explicit Bullet(const Parts& parts) : parts_(parts) {}
  std::string name() const override { return "bullet"; }
  void build() override { body_.build(parts_); }
  void take(const Asked& asked) override { asked_.build(asked.parts); }
  bool touches(const Pose& pose) override {
    asked_.object.setWorldTransform(transform(pose));
    AnyContact found;
    world_.contactPairTest(&body_.object, &asked_.object, found);
    return found.is_hit;
  }

 private:
  const Parts& parts_;
  Body body_, asked_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_{&dispatcher_, &broadphase_, &configuration_};
};

}  // namespace

void add_bullet(const Parts& parts, Contestants& contestants) {
  contestants.push_back(std::make_unique<Bullet>(parts));
}

}  // namespace graze::benchmark
