// FCL's trees of oriented boxes, of these with swept spheres, and of axis-aligned boxes, asked by
// its public function. Contact geometry is not asked for: each pair is then reported once.

#include <fcl/narrowphase/collision.h>

#include <limits>
#include <optional>

#include "tests/benchmark/common/fcl_models.h"
#include "tests/benchmark/error/peers/peers.h"

namespace graze::benchmark {
namespace {

template <typename Volume>
class FclMeshes final : public MeshContestant {
 public:
  explicit FclMeshes(const char* name)
      : MeshContestant({name, Origin::Peer, "double", std::nullopt}) {}

  void prepare(const Mesh& mesh_a, const Mesh& mesh_b) override {
    mesh_a_ = to_fcl<Volume>(mesh_a);
    mesh_b_ = to_fcl<Volume>(mesh_b);
  }
  bool any(const Pose& pose_b) override {
    collide(pose_b, 1);
    return result_.isCollision();
  }
  void find(const Pose& pose_b, std::vector<IndexPair>& pairs) override {
    collide(pose_b, std::numeric_limits<std::size_t>::max());
    pairs.clear();
    for (std::size_t i = 0; i < result_.numContacts(); ++i) {
      const fcl::Contactd& contact = result_.getContact(i);
      pairs.push_back(
          {static_cast<std::uint32_t>(contact.b1), static_cast<std::uint32_t>(contact.b2)});
    }
  }

 private:
  void collide(const Pose& pose_b, std::size_t most) {
    const fcl::CollisionRequestd request(most, /*enable_contact=*/false);
    result_.clear();
    fcl::collide(mesh_a_.get(), fcl::Transform3d::Identity(), mesh_b_.get(), to_fcl_pose(pose_b),
                 request, result_);
  }

  std::shared_ptr<fcl::BVHModel<Volume>> mesh_a_;
  std::shared_ptr<fcl::BVHModel<Volume>> mesh_b_;
  fcl::CollisionResultd result_;
};

}  // namespace

void add_fcl_meshes(MeshContestants& contestants) {
  contestants.push_back(std::make_unique<FclMeshes<fcl::OBBd>>("FCL OBB"));
  contestants.push_back(std::make_unique<FclMeshes<fcl::OBBRSSd>>("FCL OBBRSS"));
  contestants.push_back(std::make_unique<FclMeshes<fcl::AABBd>>("FCL AABB"));
}

}  // namespace graze::benchmark
