#pragma once

#include <cstdint>
#include <unordered_map>

namespace graze {

class Mesh;

/// The meshes of a world's bodies whose trees are not known to have been built. A body with such a
/// mesh carries a mark, so that nothing is looked up for any other body. When a mesh is found to
/// have a tree its entry is removed, and the marks of other bodies that share it become void.
class UnbuiltTrees {
 public:
  /// Notes that a body took the mesh, or nullptr if its shape is no mesh. True if the body is to be
  /// marked.
  bool add(const Mesh* mesh);

  /// Notes that a body with a mark has dropped its mesh.
  void remove(const Mesh& mesh);

  /// True if a body with a mark keeps its mark.
  bool still_holds(const Mesh& mesh);

  std::uint64_t count() const { return bodies_.size(); }

 private:
  /// The number of bodies with each mesh. The key is the address of the mesh's vertices, which no
  /// other mesh shares.
  std::unordered_map<const void*, std::uint32_t> bodies_;
};

}  // namespace graze
