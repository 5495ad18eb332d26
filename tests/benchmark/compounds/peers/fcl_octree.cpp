// FCL's OcTree, over one of octomap in which each full voxel is sure to be and equal eighths are
// one.

#include <fcl/geometry/octree/octree.h>
#include <fcl/narrowphase/collision.h>
#include <octomap/octomap.h>

#include "tests/benchmark/compounds/peers/fcl_parts.h"

namespace graze::benchmark {

namespace {

class FclOctree final : public BodyContestant {
 public:
  explicit FclOctree(const Voxels& voxels) : voxels_(voxels) {}
  std::string name() const override { return "fcl octree"; }
  void build() override {
    object_.reset();
    const VoxelGrid& grid = voxels_.grid;
    auto tree = std::make_shared<octomap::OcTree>(grid.edge);
    const double half = grid.edge / 2;
    for (const Voxel& voxel : voxels_.voxels)
      tree->setNodeValue(grid.plane(0, voxel.i) + half, grid.plane(1, voxel.j) + half,
                         grid.plane(2, voxel.k) + half, 3.5F, true);
    tree->updateInnerOccupancy();
    tree->prune();
    object_ = std::make_unique<fcl::CollisionObjectd>(
        std::make_shared<fcl::OcTreed>(std::shared_ptr<const octomap::OcTree>(tree)));
  }
  void take(const Asked& asked) override {
    asked_ = std::make_unique<fcl::CollisionObjectd>(to_fcl(asked.parts[0].shape));
  }
  bool touches(const Pose& pose) override {
    asked_->setTransform(to_fcl(pose));
    asked_->computeAABB();
    fcl::CollisionResultd result;
    fcl::collide(object_.get(), asked_.get(), fcl::CollisionRequestd(), result);
    return result.isCollision();
  }

 private:
  const Voxels& voxels_;
  std::unique_ptr<fcl::CollisionObjectd> object_, asked_;
};

}  // namespace

void add_fcl_octree(const Voxels& voxels, Contestants& contestants) {
  contestants.push_back(std::make_unique<FclOctree>(voxels));
}

}  // namespace graze::benchmark
