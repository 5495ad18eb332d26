#pragma once

#include <cstdint>
#include <unordered_map>

namespace graze {

class Mesh;

/// The meshes of a world's bodies of whose tree nothing has been built, as far as has been seen.
/// A body that holds one carries a mark, so that nothing is looked up for any other; where a mesh
/// is found to have a tree its entry goes, and the marks of other bodies that share it become void.
class UnbuiltTrees {
 public:
  /// A body took the mesh, or nullptr where its shape is none: whether to mark it.
  bool add(const Mesh* mesh);

  /// A body with a mark let go of its mesh.
  void remove(const Mesh& mesh);

  /// Whether a body with a mark keeps it.
  bool still_holds(const Mesh& mesh);

  std::uint64_t count() const { return bodies_.size(); }

 private:
  /// How many bodies have a mesh. It goes by where its vertices are, of which each has its own.
  std::unordered_map<const void*, std::uint32_t> bodies_;
};

}  // namespace graze
