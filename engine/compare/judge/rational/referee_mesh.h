#pragma once

#include <memory>

#include <graze/engine/compare/judge/rational/box_tree.h>
#include <graze/engine/mesh/mesh.h>

namespace graze::compare {

/// A mesh as the referee holds it for any pose: the hierarchy over its triangles, in its own frame,
/// from the mesh's vertices alone. Safe to be walked from many threads. O(n log n).
class RefereeMesh {
 public:
  explicit RefereeMesh(const Mesh& mesh);

  const Mesh& mesh() const { return mesh_; }
  const BoxTree& tree() const { return tree_; }

 private:
  Mesh mesh_;
  BoxTree tree_;
};

/// The mesh as it was held before, if it is one of the few that were asked for last: a run judges
/// thousands of questions about two meshes. Safe from many threads.
std::shared_ptr<const RefereeMesh> referee_mesh(const Mesh& mesh);

}  // namespace graze::compare
