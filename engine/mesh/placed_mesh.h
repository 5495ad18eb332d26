#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>

namespace graze {

/// A mesh in a pose, as an argument of queries: `intersects({bolt}, {nut, pose})`. It refers to the
/// mesh, which must outlive it.
struct PlacedMesh {
  const Mesh& mesh;
  Pose pose = Pose::Identity();
};

}  // namespace graze
