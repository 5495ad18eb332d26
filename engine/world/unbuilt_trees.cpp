#include <graze/engine/mesh/mesh.h>
#include <graze/engine/world/body.h>
#include <graze/engine/world/shape.h>
#include <graze/engine/world/unbuilt_trees.h>

namespace graze {
namespace {

const Mesh* mesh_of(const BodyShape& shape) {
  const Shape* known = shape.shape();
  return known == nullptr ? nullptr : known->as<Mesh>();
}

}  // namespace

bool UnbuiltTrees::add(const BodyShape& shape) {
  const Mesh* mesh = mesh_of(shape);
  if (mesh == nullptr || mesh->has_tree()) return false;
  ++bodies_[mesh->vertices().data()];
  return true;
}

void UnbuiltTrees::remove(const BodyShape& shape) {
  const auto found = bodies_.find(mesh_of(shape)->vertices().data());
  if (found != bodies_.end() && --found->second == 0) bodies_.erase(found);
}

bool UnbuiltTrees::still_holds(const BodyShape& shape) {
  const Mesh* mesh = mesh_of(shape);
  if (!mesh->has_tree()) return true;
  bodies_.erase(mesh->vertices().data());
  return false;
}

}  // namespace graze
