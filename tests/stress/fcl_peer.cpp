#include "tests/stress/fcl_peer.h"

#include <graze/engine/compare/fcl_engine.h>

namespace graze::stress {
namespace {

class FclPeer : public Peer {
 public:
  FclPeer(const Mesh& mesh_a, const Mesh& mesh_b) : mesh_a_(mesh_a), mesh_b_(mesh_b) {}

  bool intersects(const Pose& pose_a, const Pose& pose_b) const override {
    return compare::intersects(mesh_a_, pose_a, mesh_b_, pose_b);
  }

 private:
  compare::FclMesh mesh_a_;
  compare::FclMesh mesh_b_;
};

}  // namespace

std::unique_ptr<Peer> make_fcl_peer(const Mesh& mesh_a, const Mesh& mesh_b) {
  return std::make_unique<FclPeer>(mesh_a, mesh_b);
}

}  // namespace graze::stress
