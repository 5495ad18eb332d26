#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/world/bodies/unbuilt_trees.h>

namespace graze {

bool UnbuiltTrees::add(const Mesh* mesh) {
  if (mesh == nullptr || has_tree(*mesh)) return false;
  ++bodies_[mesh->vertices().data()];
  return true;
}

void UnbuiltTrees::remove(const Mesh& mesh) {
  const auto found = bodies_.find(mesh.vertices().data());
  if (found != bodies_.end() && --found->second == 0) bodies_.erase(found);
}

bool UnbuiltTrees::still_holds(const Mesh& mesh) {
  if (!has_tree(mesh)) return true;
  bodies_.erase(mesh.vertices().data());
  return false;
}

}  // namespace graze
