#pragma once

// What rays need of a mesh, and of how it is placed. Private to the library.

#include <graze/bvh/rays/ray_frame.h>
#include <graze/bvh/rays/ray_tree.h>
#include <graze/engine/mesh/placed_mesh.h>

namespace graze {

struct Work;

/// Made when a ray first asks for it, of the binary tree, O(n): up to 20 bytes a triangle more.
struct MeshRays {
  bvh::RayTree tree;
  bvh::RayFrame at_rest;  ///< the frame under a pose that is none
};
const MeshRays& rays_of(const Mesh& mesh, Work* work = nullptr);

/// Bit for bit.
bool is_identity(const Pose& pose);

/// The frame of a placed mesh's tree. Throws PoseError for a pose that is refused by law 10 or by
/// law 1.
bvh::RayFrame ray_frame_of(const PlacedMeshView& placed, const bvh::LocalFrame& local);

}  // namespace graze
