#pragma once

// What the handles of one mesh share. Private to engine/mesh.

#include <graze/bvh/skins/float_volumes.h>
#include <graze/bvh/tree/tree.h>
#include <graze/bvh/wide/tree/wide_tree.h>
#include <graze/engine/mesh/data/inherited.h>
#include <graze/engine/mesh/data/mesh_rays.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/data/orientation.h>
#include <graze/engine/mesh/data/vertex_fans.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/placing/far_apart.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace graze {

/// A binary tree, and what its subtrees cost when they were built: nothing if that was when they
/// came to be.
struct AgedTree {
  bvh::Tree tree;
  std::vector<float> costs;
};

/// Made by the constructor, but for what is computed when first asked for, each behind its flag.
struct Mesh::Data {
  template <typename Volume>
  struct Skin {
    std::once_flag flag;
    std::vector<Volume> volumes;
  };

  std::vector<Eigen::Vector3d> vertices;
  std::shared_ptr<const std::vector<TriangleIndices>> shared_triangles;  ///< of all deformations
  std::span<const TriangleIndices> triangles;
  Aabb bounds;                                                  ///< of a patch that of the whole
  MeshBall ball;                                                ///< around all vertices
  std::shared_ptr<const std::vector<std::uint16_t>> materials;  ///< nullptr if there are none

  std::vector<std::uint32_t> vertex_numbers;    ///< of a patch, in the whole; else empty
  std::vector<std::uint32_t> triangle_numbers;  ///< likewise
  std::vector<std::uint8_t> is_rim;             ///< of a patch, by vertex; see MeshPatch

  mutable std::once_flag tree_flag;
  mutable std::atomic<bool> is_tree_made = false;
  mutable std::shared_ptr<const AgedTree> tree;
  mutable Inherited<AgedTree> older_tree;
  mutable Skin<bvh::FloatSphere> spheres;
  mutable Skin<bvh::FloatObb> obbs;
  mutable Skin<bvh::FloatKDop> kdops;
  mutable std::once_flag rays_flag;
  mutable std::atomic<bool> are_rays_made = false;
  mutable std::unique_ptr<const MeshRays> rays;
  mutable std::once_flag wide_flag;
  mutable std::atomic<bool> is_wide_made = false;
  mutable std::unique_ptr<bvh::CornerSource> corners;
  mutable std::unique_ptr<bvh::WideTree> wide;
  mutable Inherited<bvh::WideStock> older_wide;
  mutable std::once_flag welded_flag;
  mutable std::vector<std::uint32_t> welded;
  mutable std::once_flag fans_flag;
  mutable VertexFans fans;
  mutable std::once_flag orientation_flag;
  mutable Orientation orientation;
  mutable std::once_flag topology_flag;
  mutable Topology topology;
  mutable std::vector<std::uint32_t> component_vertices;

  /// What a deformation of this mesh can make its trees of: this mesh's own, or what these would
  /// have been made of; nothing if there are none. Safe beside queries.
  std::shared_ptr<const AgedTree> tree_to_inherit() const;
  std::shared_ptr<const bvh::WideStock> wide_to_inherit() const;
};

/// The way to what the handles share, for the sources of this room.
struct MeshAccess {
  static const Mesh::Data& data(const Mesh& mesh) { return *mesh.data_; }
  static std::shared_ptr<Mesh::Data> new_data() { return std::make_shared<Mesh::Data>(); }
  static Mesh mesh(std::shared_ptr<const Mesh::Data> data) { return Mesh(std::move(data)); }
};

}  // namespace graze
