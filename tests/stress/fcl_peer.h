#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>

#include <memory>

namespace graze::stress {

/// Another engine that answers for the same two meshes.
class Peer {
 public:
  virtual ~Peer() = default;
  virtual bool intersects(const Pose& pose_a, const Pose& pose_b) const = 0;
};

/// FCL, or nothing if the project is built without it.
std::unique_ptr<Peer> make_fcl_peer(const Mesh& mesh_a, const Mesh& mesh_b);

}  // namespace graze::stress
