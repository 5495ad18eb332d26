// Asks Bullet through the interface that every engine has: GImpact meshes and shapes without
// margin, in double. Its shapes keep state while they are asked.

#include <graze/engine/cases/text/case_words.h>
#include <graze/engine/compare/peers/adaptors.h>
#include <graze/engine/compare/peers/bullet_casts.h>
#include <graze/engine/compare/peers/bullet_geometry.h>
#include <graze/engine/compare/peers/shape_answers.h>

#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

namespace graze::compare {
namespace {

class BulletMesh {
 public:
  explicit BulletMesh(const Mesh& mesh) : shape_(&triangles_) {
    add_triangles(mesh, triangles_);
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
    nearest = std::min(nearest, point.getDistance());
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
  double nearest = std::numeric_limits<double>::infinity();  ///< the nearest of all points, apart
                                                             ///< or not
};

/// Tests two objects at a time.
class PairTest {
 public:
  PairTest() : dispatcher_(&configuration_), world_(&dispatcher_, &broadphase_, &configuration_) {
    // contactPairTest() asks the table of closest points, into which GImpact does not enter itself.
    for (int type = 0; type < MAX_BROADPHASE_COLLISION_TYPES; ++type) {
      dispatcher_.registerClosestPointsCreateFunc(GIMPACT_SHAPE_PROXYTYPE, type, &create_gimpact_);
      dispatcher_.registerClosestPointsCreateFunc(type, GIMPACT_SHAPE_PROXYTYPE, &create_gimpact_);
    }
  }

  std::vector<CaseContact> contacts(btCollisionObject* a, btCollisionObject* b) {
    Collector collector;
    collector.first = a;
    world_.contactPairTest(a, b, collector);
    return std::move(collector.contacts);
  }

  /// Returns the distance of the nearest points that Bullet's GJK finds, however far apart; below 0
  /// they meet. Returns nothing if it finds none.
  std::optional<double> distance(btCollisionObject* a, btCollisionObject* b) {
    constexpr double kAnyDistance = 1e30;
    Collector collector;
    collector.first = a;
    collector.m_closestDistanceThreshold = kAnyDistance;
    world_.contactPairTest(a, b, collector);
    return std::isfinite(collector.nearest) ? std::optional(collector.nearest) : std::nullopt;
  }

 private:
  btGImpactCollisionAlgorithm::CreateFunc create_gimpact_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_;
};

class BulletPair : public LoadedPair {
 public:
  BulletPair(const Mesh& mesh_a, const Mesh& mesh_b) : mesh_a_(mesh_a), mesh_b_(mesh_b) {}

  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    if (!question.is_plain()) return std::nullopt;
    if (question.ask != Ask::Any && question.ask != Ask::Contacts) return std::nullopt;
    std::vector<CaseContact> contacts =
        test_.contacts(mesh_a_.place(pose_a), mesh_b_.place(pose_b));
    CaseAnswer answer;
    if (question.ask == Ask::Any) {
      answer.says = !contacts.empty();
    } else {
      answer.contacts = std::move(contacts);
    }
    return answer;
  }

 private:
  mutable BulletMesh mesh_a_;
  mutable BulletMesh mesh_b_;
  mutable PairTest test_;
};

/// Holds two objects of one shape, so that it can meet itself.
class BulletShape {
 public:
  explicit BulletShape(const Shape& shape)
      : kind_(shape.kind()), centre_(bullet_centre(shape)), shape_(bullet_shape(shape)) {
    if (const Mesh* mesh = shape.as<Mesh>()) {
      for (auto& each : meshes_)
        each = std::make_unique<BulletMesh>(*mesh);
      return;
    }
    if (!shape_) return;
    for (btCollisionObject& object : objects_)
      object.setCollisionShape(shape_.get());
  }

  ShapeKind kind() const { return kind_; }
  bool is_known() const { return shape_ || meshes_[0]; }

  btCollisionObject* place(std::size_t which, Pose pose) {
    if (meshes_[which]) return meshes_[which]->place(pose);
    pose.translation() = pose * centre_;
    objects_[which].setWorldTransform(to_bullet(pose));
    return &objects_[which];
  }

 private:
  ShapeKind kind_;
  Eigen::Vector3d centre_;
  std::unique_ptr<btCollisionShape> shape_;
  std::array<btCollisionObject, 2> objects_;
  std::array<std::unique_ptr<BulletMesh>, 2> meshes_;
};

class BulletShapes : public LoadedShapes {
 public:
  explicit BulletShapes(std::span<const Shape> shapes) : casts_(shapes, BulletCast::Continuous) {
    for (const Shape& shape : shapes)
      shapes_.push_back(std::make_unique<BulletShape>(shape));
  }

  std::optional<bool> intersects(std::size_t shape_a, const Pose& pose_a, std::size_t shape_b,
                                 const Pose& pose_b) const override {
    BulletShape& a = *shapes_[shape_a];
    BulletShape& b = *shapes_[shape_b];
    if (!knows(a, b)) return std::nullopt;
    return !test_.contacts(a.place(0, pose_a), b.place(1, pose_b)).empty();
  }

  /// Answers other questions. GImpact knows no distance of meshes, and first contacts of two meshes
  /// are not known.
  std::optional<CaseAnswer> answer(const Question& question, const PlacedShape& placed_a,
                                   const PlacedShape& placed_b) const override {
    if (cases::is_about_motion(question.ask)) return casts_.answer(question, placed_a, placed_b);
    BulletShape& a = *shapes_[placed_a.shape];
    BulletShape& b = *shapes_[placed_b.shape];
    if (!knows(a, b)) return std::nullopt;
    btCollisionObject* object_a = a.place(0, placed_a.pose);
    btCollisionObject* object_b = b.place(1, placed_b.pose);
    if (question.ask == Ask::Contacts) return contacts(object_a, object_b);
    if (question.ask == Ask::Separation)
      return answer_of_separation(*contacts(object_a, object_b).manifold);
    if (a.kind() == ShapeKind::Mesh || b.kind() == ShapeKind::Mesh) return std::nullopt;
    if (question.ask == Ask::Distance)
      return answer_of_distance(test_.distance(object_a, object_b));
    if (question.ask == Ask::Within)
      return answer_of_within(test_.distance(object_a, object_b), question.settings.clearance);
    return std::nullopt;
  }

 private:
  static bool knows(const BulletShape& a, const BulletShape& b) {
    const bool are_planes = a.kind() == ShapeKind::HalfSpace && b.kind() == ShapeKind::HalfSpace;
    return a.is_known() && b.is_known() && !are_planes;
  }

  CaseAnswer contacts(btCollisionObject* a, btCollisionObject* b) const {
    CaseAnswer answer;
    answer.manifold.emplace();
    for (const CaseContact& c : test_.contacts(a, b))
      add_contact(c.point, c.normal, c.depth, *answer.manifold);
    return answer;
  }

  std::vector<std::unique_ptr<BulletShape>> shapes_;
  mutable PairTest test_;
  BulletCasts casts_;
};

class BulletEngine : public Engine {
 public:
  CaseWitness name() const override { return {"bullet", std::to_string(btGetVersion())}; }
  std::optional<std::vector<Ask>> questions() const override {
    return {{Ask::Any, Ask::Distance, Ask::Within, Ask::Contacts, Ask::Separation,
             Ask::FirstContact, Ask::Free}};
  }
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    return std::make_unique<BulletPair>(mesh_a, mesh_b);
  }
  std::unique_ptr<LoadedShapes> load_shapes(std::span<const Shape> shapes) const override {
    return std::make_unique<BulletShapes>(shapes);
  }
};

}  // namespace

std::unique_ptr<Engine> make_bullet_engine() {
  return std::make_unique<BulletEngine>();
}

}  // namespace graze::compare
