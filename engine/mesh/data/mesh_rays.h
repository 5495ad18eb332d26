#pragma once

// Rays need this of a mesh, and of how it is placed. It is private to the library.

#include <graze/bvh/rays/ray_frame.h>
#include <graze/bvh/rays/ray_tree.h>
#include <graze/engine/mesh/placed_mesh.h>

#include <bit>
#include <cstdint>

namespace graze {

struct Work;

/// The tree for rays, which is made of the binary tree when a ray first asks for it, in O(n). It
/// takes up to 20 bytes a triangle more.
struct MeshRays {
  bvh::RayTree tree;
  bvh::RayFrame at_rest;  ///< the frame under the identity
};
const MeshRays& rays_of(const Mesh& mesh, Work* work = nullptr);

/// True if the pose is the identity, bit for bit.
inline bool is_identity(const Pose& pose) {
  // This is not a call of memcmp(), which takes longer: each ray asks.
  constexpr auto kOne = std::bit_cast<std::uint64_t>(1.0);
  std::uint64_t differences = 0;
  for (int i = 0; i < 16; ++i)
    differences |= std::bit_cast<std::uint64_t>(pose.data()[i]) ^ (i % 5 == 0 ? kOne : 0);
  return differences == 0;
}

/// Returns the frame of a placed mesh's tree. Throws PoseError for a pose that is refused by law 10
/// or by law 1.
bvh::RayFrame ray_frame_of(const PlacedMeshView& placed, const bvh::LocalFrame& local);

}  // namespace graze
