#pragma once

// What is behind the surface of a mesh without touching it. Private to engine/world.

#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/work.h>
#include <graze/engine/world/contacts/contact_functions.h>
#include <graze/engine/world/contacts/contact_regions.h>
#include <graze/engine/world/placed_shape.h>
#include <graze/engine/world/sides.h>
#include <graze/narrowphase/convex/core/core.h>

#include <vector>

namespace graze {

/// Throws InputError for sides of what is no mesh or a thickness that is none, and MeshError, with
/// the edge, where the mesh does not tell its sides apart. what() begins with `what`.
void check_sides(const Shape* shape, const MeshSides& sides, const char* what);

/// A body beside a mesh whose surface it does not touch. Convex bodies leave as they are; of a mesh
/// the hull of its vertices does.
class Enclosure {
 public:
  Enclosure(const PlacedShapeView& body, const PlacedShapeView& mesh, const MeshSides& sides,
            Work& work)
      : body_(body), mesh_{*mesh.shape.as<Mesh>(), mesh.pose}, sides_(sides), work_(work) {}

  /// Whether the body, or a part of it, is inside the solid, or behind the surface by no more than
  /// its thickness.
  bool holds() const;

  /// If so, the contacts of the body and the mesh: where it leaves soonest through a triangle that
  /// it then is before. Looks at triangles nearer ones first, and no farther than the way is long.
  void add(ContactCandidates& candidates) const;

 private:
  class Exits;

  bool is_inside() const;
  bool is_behind() const;
  narrowphase::Core core(const Eigen::Vector3d& origin,
                         std::vector<narrowphase::Vec3>& points) const;

  const PlacedShapeView& body_;
  PlacedMeshView mesh_;
  const MeshSides& sides_;
  Work& work_;
};

}  // namespace graze
