#pragma once

// What the handles of one mesh share. Private to engine/mesh.

#include <graze/bvh/skins/float_volumes.h>
#include <graze/bvh/tree.h>
#include <graze/bvh/wide/wide_tree.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/vertex_fans.h>

#include <memory>
#include <mutex>
#include <vector>

namespace graze {

/// Made by the constructor, but for what is computed when first asked for, each behind its flag.
struct Mesh::Data {
  template <typename Volume>
  struct Skin {
    std::once_flag flag;
    std::vector<Volume> volumes;
  };

  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  Aabb bounds;

  mutable std::once_flag tree_flag;
  mutable bvh::Tree tree;
  mutable Skin<bvh::FloatSphere> spheres;
  mutable Skin<bvh::FloatObb> obbs;
  mutable Skin<bvh::FloatKDop> kdops;
  mutable std::once_flag wide_flag;
  mutable std::unique_ptr<bvh::CornerSource> corners;
  mutable std::unique_ptr<bvh::WideTree> wide;
  mutable std::once_flag welded_flag;
  mutable std::vector<std::uint32_t> welded;
  mutable std::once_flag fans_flag;
  mutable VertexFans fans;
  mutable std::once_flag topology_flag;
  mutable Topology topology;
  mutable std::vector<std::uint32_t> component_vertices;
};

}  // namespace graze
