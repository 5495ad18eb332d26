#pragma once

// The handles of one mesh share this data. It is private to engine/mesh.

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
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace graze {

/// A binary tree, and the costs of its subtrees when they were built; there are none if that was
/// when they came to be.
struct AgedTree {
  bvh::Tree tree;
  std::vector<float> costs;
};

/// The data of a mesh. The constructor makes it, but for what is computed when first asked for,
/// each behind its flag.
struct Mesh::Data {
  template <typename Volume>
  struct Skin {
    std::once_flag flag;
    std::vector<Volume> volumes;
  };

  std::vector<Eigen::Vector3d> vertices;
  std::shared_ptr<const std::vector<TriangleIndices>> shared_triangles;  ///< those of all
                                                                         ///< deformations
  std::span<const TriangleIndices> triangles;
  Aabb bounds;                                                  ///< those of the mesh; of a patch,
                                                                ///< those of the whole
  MeshBall ball;                                                ///< around all vertices
  std::shared_ptr<const std::vector<std::uint16_t>> materials;  ///< nullptr if there are none

  std::vector<std::uint32_t> vertex_numbers;    ///< the numbers of a patch's vertices in the whole;
                                                ///< else empty
  std::vector<std::uint32_t> triangle_numbers;  ///< the numbers of a patch's triangles in the
                                                ///< whole; else empty
  std::vector<std::uint8_t> is_rim;             ///< for each vertex of a patch, see MeshPatch

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
  mutable std::once_flag inside_out_flag;
  mutable std::optional<std::uint32_t> inside_out;  ///< what first_inside_out() returns
  mutable std::once_flag topology_flag;
  mutable Topology topology;
  mutable std::vector<std::uint32_t> component_vertices;

  /// Return what a deformation of this mesh can make its trees of: this mesh's own, or what these
  /// would have been made of; nothing if there are none. They may be called beside queries.
  std::shared_ptr<const AgedTree> tree_to_inherit() const;
  std::shared_ptr<const bvh::WideStock> wide_to_inherit() const;
};

/// The way to the data that the handles share, for the sources of engine/mesh.
struct MeshAccess {
  static const Mesh::Data& data(const Mesh& mesh) { return *mesh.data_; }
  static std::shared_ptr<Mesh::Data> new_data() { return std::make_shared<Mesh::Data>(); }
  static Mesh mesh(std::shared_ptr<const Mesh::Data> data) { return Mesh(std::move(data)); }
};

}  // namespace graze
