// Bullet, compiled for double: contactPairTest() of two GImpact meshes with margins of 0, the way
// to ask it about two concave meshes. It has no early way out, so that yes or no costs as much as
// all contacts; the pairs are those that have one.

#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <btBulletCollisionCommon.h>

#include <algorithm>
#include <memory>

#include "tests/benchmark/pairs/peers/peers.h"

static_assert(sizeof(btScalar) == sizeof(double), "compile this file with BT_USE_DOUBLE_PRECISION");

namespace graze::benchmark {
namespace {

/// A collision object and what it refers to.
class Body {
 public:
  explicit Body(const Mesh& mesh) {
    for (const Eigen::Vector3d& p : mesh.vertices())
      vertices_.insert(vertices_.end(), {p.x(), p.y(), p.z()});
    for (const TriangleIndices& t : mesh.triangles())
      for (const std::uint32_t index : t)
        indices_.push_back(static_cast<int>(index));
    arrays_ = std::make_unique<btTriangleIndexVertexArray>(
        static_cast<int>(mesh.triangles().size()), indices_.data(), 3 * sizeof(int),
        static_cast<int>(mesh.vertices().size()), vertices_.data(), 3 * sizeof(double));
    shape_ = std::make_unique<btGImpactMeshShape>(arrays_.get());
    shape_->setMargin(0);
    shape_->updateBound();
    object_.setCollisionShape(shape_.get());
  }

  void move(const Pose& pose) {
    const auto& r = pose.linear();
    const auto& t = pose.translation();
    object_.setWorldTransform(btTransform(btMatrix3x3(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1),
                                                      r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
                                          btVector3(t.x(), t.y(), t.z())));
  }

  btCollisionObject* object() { return &object_; }

 private:
  std::vector<double> vertices_;
  std::vector<int> indices_;
  std::unique_ptr<btTriangleIndexVertexArray> arrays_;
  std::unique_ptr<btGImpactMeshShape> shape_;
  btCollisionObject object_;
};

struct Collected : btCollisionWorld::ContactResultCallback {
  explicit Collected(const btCollisionObject* first_object) : a(first_object) {}

  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* first, int,
                           int index_0, const btCollisionObjectWrapper*, int,
                           int index_1) override {
    if (point.getDistance() > 0) return 0;
    const bool is_in_order = first->getCollisionObject() == a;
    pairs.push_back({static_cast<std::uint32_t>(is_in_order ? index_0 : index_1),
                     static_cast<std::uint32_t>(is_in_order ? index_1 : index_0)});
    return 0;
  }

  const btCollisionObject* a;
  std::vector<TrianglePair> pairs;
};

class BulletPairs final : public PairContestant {
 public:
  BulletPairs() : PairContestant("Bullet GImpact") {
    // Its own registration leaves out the algorithms that contactPairTest() looks up: all would be
    // apart.
    btGImpactCollisionAlgorithm::registerAlgorithm(&dispatcher_);
    for (int type = 0; type < MAX_BROADPHASE_COLLISION_TYPES; ++type) {
      dispatcher_.registerClosestPointsCreateFunc(GIMPACT_SHAPE_PROXYTYPE, type, &create_);
      dispatcher_.registerClosestPointsCreateFunc(type, GIMPACT_SHAPE_PROXYTYPE, &create_);
    }
  }

  std::string refusal(Question question) const override {
    return question == Question::Any || question == Question::Pairs
               ? ""
               : "it has no distance of concave meshes";
  }
  void build(const Mesh& mesh_a, const Mesh& mesh_b) override {
    a_ = std::make_unique<Body>(mesh_a);
    b_ = std::make_unique<Body>(mesh_b);
  }
  void release() override {
    a_.reset();
    b_.reset();
  }
  bool any(const Pose& pose_b) override {
    find(pose_b, pairs_);
    return !pairs_.empty();
  }
  void find(const Pose& pose_b, std::vector<TrianglePair>& pairs) override {
    b_->move(pose_b);
    Collected collected(a_->object());
    world_.contactPairTest(a_->object(), b_->object(), collected);
    pairs = std::move(collected.pairs);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  }

 private:
  btGImpactCollisionAlgorithm::CreateFunc create_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_{&dispatcher_, &broadphase_, &configuration_};
  std::unique_ptr<Body> a_;
  std::unique_ptr<Body> b_;
  std::vector<TrianglePair> pairs_;
};

}  // namespace

void add_bullet(PairContestants& contestants) {
  contestants.push_back(std::make_unique<BulletPairs>());
}

}  // namespace graze::benchmark
