#pragma once

// Finds bodies that are behind the surface of a mesh without touching it. Private to engine/world.

#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/work.h>
#include <graze/engine/world/contacts/contact_functions.h>
#include <graze/engine/world/contacts/contact_regions.h>
#include <graze/engine/world/placed_shape.h>
#include <graze/engine/world/sides.h>
#include <graze/narrowphase/convex/core/core.h>

#include <vector>

namespace graze {

/// Throws InputError for sides of a shape that is no mesh or for an invalid thickness, and
/// MeshError, with the edge, if the mesh does not tell its sides apart. what() begins with `what`.
void check_sides(const Shape* shape, const MeshSides& sides, const char* what);

/// A body beside a mesh whose surface it does not touch. A body that is a mesh leaves as the convex
/// hull of its vertices.
class Enclosure {
 public:
  Enclosure(const PlacedShapeView& body, const PlacedShapeView& mesh, const MeshSides& sides,
            Work& work)
      : body_(body), mesh_{*mesh.shape.as<Mesh>(), mesh.pose}, sides_(sides), work_(work) {}

  /// True if the body, or a part of it, is inside the solid, or behind the surface by no more than
  /// its thickness.
  bool holds() const;

  /// Adds the contacts of the body and the mesh, if holds() is true: along the shortest way out
  /// through a triangle that the body then lies before. Looks at nearer triangles first, and no
  /// farther than that way is long.
  void add(ContactCandidates& candidates) const;

 private:
  class Exits;

  /// The points of a body that is a mesh, and which of its vertices they are.
  struct Scratch {
    std::vector<narrowphase::Vec3> points;
    std::vector<bool> is_taken;
  };

  bool is_inside() const;
  bool is_behind() const;
  bool is_beside(const Eigen::Vector3d& nearest) const;
  static void leave_by(const narrowphase::Exit& exit, const narrowphase::Core& core,
                       const narrowphase::Core& triangle, ContactCandidates& candidates);
  Eigen::Vector3d origin() const;
  narrowphase::Core core(const Eigen::Vector3d& origin, Scratch& scratch) const;

  const PlacedShapeView& body_;
  PlacedMeshView mesh_;
  const MeshSides& sides_;
  Work& work_;
};

}  // namespace graze
