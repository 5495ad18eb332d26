// Bullet behind the page that every engine has: GImpact meshes without margin, in double. Its
// shapes keep state while they are asked, so that one thread at a time may ask.

#include <graze/engine/compare/peers/engine.h>

#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <btBulletCollisionCommon.h>
#include <algorithm>
#include <mutex>

static_assert(sizeof(btScalar) == sizeof(double), "compile this file with BT_USE_DOUBLE_PRECISION");

namespace graze::compare {
namespace {

btTransform to_bullet(const Pose& pose) {
  return btTransform(btMatrix3x3(pose(0, 0), pose(0, 1), pose(0, 2), pose(1, 0), pose(1, 1),
                                 pose(1, 2), pose(2, 0), pose(2, 1), pose(2, 2)),
                     btVector3(pose(0, 3), pose(1, 3), pose(2, 3)));
}

Eigen::Vector3d from_bullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

btTriangleMesh triangles_of(const Mesh& mesh) {
  btTriangleMesh triangles;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    const Triangle t = mesh.triangle(i);
    triangles.addTriangle({t.a.x(), t.a.y(), t.a.z()}, {t.b.x(), t.b.y(), t.b.z()},
                          {t.c.x(), t.c.y(), t.c.z()});
  }
  return triangles;
}

class BulletMesh {
 public:
  explicit BulletMesh(const Mesh& mesh) : triangles_(triangles_of(mesh)), shape_(&triangles_) {
    shape_.setMargin(0);
    shape_.updateBound();
    object_.setCollisionShape(&shape_);
  }
  BulletMesh(const BulletMesh&) = delete;
  BulletMesh& operator=(const BulletMesh&) = delete;

  btCollisionObject* place(const Pose& pose) {
    object_.setWorldTransform(to_bullet(pose));
    return &object_;
  }

 private:
  btTriangleMesh triangles_;
  btGImpactMeshShape shape_;
  btCollisionObject object_;
};

class Collector : public btCollisionWorld::ContactResultCallback {
 public:
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* object_0, int,
                           int, const btCollisionObjectWrapper*, int, int) override {
    if (point.getDistance() > 0) return 0;
    // The normal points from the second object to the first, whichever of the two comes first.
    const bool is_swapped = object_0->getCollisionObject() != first;
    const Eigen::Vector3d normal = from_bullet(point.m_normalWorldOnB) * (is_swapped ? 1.0 : -1.0);
    const Eigen::Vector3d on_a = from_bullet(point.getPositionWorldOnA());
    const Eigen::Vector3d on_b = from_bullet(point.getPositionWorldOnB());
    contacts.push_back({(on_a + on_b) / 2, is_swapped ? on_b : on_a, is_swapped ? on_a : on_b,
                        normal, -point.getDistance()});
    return 0;
  }
  const btCollisionObject* first = nullptr;
  std::vector<CaseContact> contacts;
};

class BulletPair : public LoadedPair {
 public:
  BulletPair(const Mesh& mesh_a, const Mesh& mesh_b)
      : mesh_a_(mesh_a),
        mesh_b_(mesh_b),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &configuration_) {
    // contactPairTest() asks the table of closest points, into which GImpact does not enter itself.
    for (int type = 0; type < MAX_BROADPHASE_COLLISION_TYPES; ++type) {
      dispatcher_.registerClosestPointsCreateFunc(GIMPACT_SHAPE_PROXYTYPE, type, &create_gimpact_);
      dispatcher_.registerClosestPointsCreateFunc(type, GIMPACT_SHAPE_PROXYTYPE, &create_gimpact_);
    }
  }

  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    if (question.settings.touch == Touch::Exclude) return std::nullopt;
    if (question.settings.interior == Interior::Solid) return std::nullopt;
    if (question.ask != Ask::Any && question.ask != Ask::Contacts) return std::nullopt;
    const std::lock_guard lock(mutex_);
    Collector collector;
    btCollisionObject* const a = mesh_a_.place(pose_a);
    collector.first = a;
    world_.contactPairTest(a, mesh_b_.place(pose_b), collector);
    CaseAnswer answer;
    if (question.ask == Ask::Any) {
      answer.says = !collector.contacts.empty();
    } else {
      answer.contacts = std::move(collector.contacts);
    }
    return answer;
  }

 private:
  mutable std::mutex mutex_;
  mutable BulletMesh mesh_a_;
  mutable BulletMesh mesh_b_;
  btGImpactCollisionAlgorithm::CreateFunc create_gimpact_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  mutable btCollisionWorld world_;
};

class BulletEngine : public Engine {
 public:
  CaseWitness name() const override { return {"bullet", std::to_string(btGetVersion())}; }
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    return std::make_unique<BulletPair>(mesh_a, mesh_b);
  }
};

}  // namespace

std::unique_ptr<Engine> make_bullet_engine() {
  return std::make_unique<BulletEngine>();
}

}  // namespace graze::compare
