// Bullet's oriented boxes: its clipping of boxes (ODE's, once), which looks for contacts.

#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>

#include "tests/benchmark/error/peers/peers.h"

static_assert(sizeof(btScalar) == sizeof(double), "compile this file with BT_USE_DOUBLE_PRECISION");

namespace graze::benchmark {
namespace {

struct PlacedBox {
  explicit PlacedBox(const Obb& box)
      : half(box.half_extents.x(), box.half_extents.y(), box.half_extents.z()) {
    const double* m = box.pose.data();  // column-major 4x4
    pose.setBasis({m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10]});
    pose.setOrigin({m[12], m[13], m[14]});
  }
  btVector3 half;
  btTransform pose;
};

struct Boxes {
  PlacedBox a;
  PlacedBox b;
};

bool meet(const Boxes& pair) {
  const btBoxShape a(pair.a.half);
  const btBoxShape b(pair.b.half);
  btBoxBoxDetector detector(&a, &b);
  btDiscreteCollisionDetectorInterface::ClosestPointInput input;
  input.m_transformA = pair.a.pose;
  input.m_transformB = pair.b.pose;
  btPointCollector result;
  detector.getClosestPoints(input, result, nullptr);
  return result.m_hasResult;
}

}  // namespace

void add_bullet_volumes(Field& field) {
  add(
      field.obb_pairs, {"Bullet", Origin::Peer, "double", std::nullopt},
      [](const ObbPair& pair) {
        return Boxes{PlacedBox(pair.a), PlacedBox(pair.b)};
      },
      meet);
}

}  // namespace graze::benchmark
