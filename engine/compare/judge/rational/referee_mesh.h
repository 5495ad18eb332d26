#pragma once

#include <memory>

#include <graze/engine/compare/judge/rational/box_tree.h>
#include <graze/engine/mesh/mesh.h>

namespace graze::compare {

/// Holds a mesh as the referee does for any pose: the hierarchy over its triangles, in its own
/// frame, from the mesh's vertices alone. Many threads may walk it. Building takes O(n log n).
class RefereeMesh {
 public:
  explicit RefereeMesh(const Mesh& mesh);

  const Mesh& mesh() const { return mesh_; }
  const BoxTree& tree() const { return tree_; }

 private:
  Mesh mesh_;
  BoxTree tree_;
};

/// Returns the mesh as it was held before, if it is one of the few that were asked for last: a run
/// judges thousands of questions about two meshes. Many threads may call this.
std::shared_ptr<const RefereeMesh> referee_mesh(const Mesh& mesh);

}  // namespace graze::compare
