// Bullet, compiled for double: performDiscreteCollisionDetection() with its default dispatcher, up
// to four contacts a pair. What does not move is a btBvhTriangleMeshShape, what moves is a box, a
// sphere or a btGImpactMeshShape; margins are 0.

#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <btBulletCollisionCommon.h>

#include "tests/benchmark/world/peers/peers.h"

static_assert(sizeof(btScalar) == sizeof(double), "compile this file with BT_USE_DOUBLE_PRECISION");

namespace graze::benchmark {
namespace {

btTransform transform(const Pose& pose) {
  const auto& r = pose.linear();
  const auto& t = pose.translation();
  return btTransform(
      btMatrix3x3(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
      btVector3(t.x(), t.y(), t.z()));
}

struct Triangles {
  explicit Triangles(const Mesh& mesh) {
    for (const Eigen::Vector3d& p : mesh.vertices())
      vertices.insert(vertices.end(), {p.x(), p.y(), p.z()});
    for (const TriangleIndices& t : mesh.triangles()) {
      for (const std::uint32_t index : t)
        indices.push_back(static_cast<int>(index));
    }
    arrays = std::make_unique<btTriangleIndexVertexArray>(
        static_cast<int>(mesh.triangles().size()), indices.data(), 3 * sizeof(int),
        static_cast<int>(mesh.vertices().size()), vertices.data(), 3 * sizeof(double));
  }
  std::vector<double> vertices;
  std::vector<int> indices;
  std::unique_ptr<btTriangleIndexVertexArray> arrays;
};

class Bullet final : public Contestant {
 public:
  Bullet() { btGImpactCollisionAlgorithm::registerAlgorithm(&dispatcher_); }
  ~Bullet() override {
    for (const auto& object : objects_)
      world_.removeCollisionObject(object.get());
  }

  void start(const Scene& scene, const Frame& frame) override {
    const auto& ground = triangles_.emplace_back(std::make_unique<Triangles>(scene.ground));
    shapes_.push_back(std::make_unique<btBvhTriangleMeshShape>(ground->arrays.get(), true));
    for (const Kind& kind : scene.kinds)
      shapes_.push_back(shape_of(kind.shape));
    for (const auto& shape : shapes_)
      shape->setMargin(0);
    add(*shapes_[0], Pose::Identity(), btBroadphaseProxy::StaticFilter,
        btBroadphaseProxy::DefaultFilter);
    objects_[0]->setCollisionFlags(btCollisionObject::CF_STATIC_OBJECT);
    for (std::size_t i = 0; i < frame.size(); ++i) {
      add(*shapes_[1 + scene.bodies[i]], frame[i], btBroadphaseProxy::DefaultFilter,
          btBroadphaseProxy::AllFilter);
      objects_.back()->setCollisionFlags(0);
    }
    step(frame);
  }

  Counts step(const Frame& frame) override {
    for (std::size_t i = 0; i < frame.size(); ++i)
      objects_[i + 1]->setWorldTransform(transform(frame[i]));
    world_.performDiscreteCollisionDetection();
    Counts counts;
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
      const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(i);
      std::size_t touching = 0;
      for (int k = 0; k < manifold.getNumContacts(); ++k)
        touching += manifold.getContactPoint(k).getDistance() <= 0;
      counts.pairs += touching != 0;
      counts.contacts += touching;
    }
    return counts;
  }

 private:
  std::unique_ptr<btCollisionShape> shape_of(const Shape& shape) {
    if (const Box* box = shape.as<Box>()) {
      const Eigen::Vector3d& h = box->half_extents;
      return std::make_unique<btBoxShape>(btVector3(h.x(), h.y(), h.z()));
    }
    if (const Sphere* sphere = shape.as<Sphere>())
      return std::make_unique<btSphereShape>(sphere->radius);
    triangles_.push_back(std::make_unique<Triangles>(*shape.as<Mesh>()));
    auto mesh = std::make_unique<btGImpactMeshShape>(triangles_.back()->arrays.get());
    mesh->setMargin(0);
    mesh->updateBound();
    return mesh;
  }

  void add(btCollisionShape& shape, const Pose& pose, int group, int mask) {
    objects_.push_back(std::make_unique<btCollisionObject>());
    objects_.back()->setCollisionShape(&shape);
    objects_.back()->setWorldTransform(transform(pose));
    world_.addCollisionObject(objects_.back().get(), group, mask);
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_{&dispatcher_, &broadphase_, &configuration_};
  std::vector<std::unique_ptr<Triangles>> triangles_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
};

}  // namespace

void add_bullet(std::vector<Entry>& entries) {
  entries.push_back({"Bullet", [] { return std::make_unique<Bullet>(); }});
}

}  // namespace graze::benchmark
