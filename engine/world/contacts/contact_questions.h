#pragma once

// What each row of the table of pairs offers as contacts; A's kind is not above B's, and points are
// relative to the origin that is handed back. Private to engine/world.

#include <graze/engine/world/shapes/pair_input.h>
#include <graze/narrowphase/convex/contact/contact_points.h>

#include <vector>

namespace graze {

/// What is offered. Kept from one question to the next, so that no step of a simulation allocates.
struct Touches {
  Eigen::Vector3d origin;
  std::vector<narrowphase::ContactPoint> list;
  std::vector<narrowphase::ContactPoint> from_behind;  ///< of a mesh, its triangles seen so
  std::vector<narrowphase::ContactPoint> found;        ///< what is at hand
  std::vector<bool> is_seen;                           ///< of a mesh, its vertices

  void clear() {
    list.clear();
    from_behind.clear();
  }
};

void touches_of_cores(const PlacedShape& a, const PlacedShape& b, Touches& touches, Work& work);
/// Two boxes, which need not touch: no contacts then.
void touches_of_boxes(const PlacedShape& a, const PlacedShape& b, Touches& touches, Work& work);
void touches_with_plane(const PlacedShape& a, const PlacedShape& b, Touches& touches);
void touches_of_mesh_plane(const PlacedShape& a, const PlacedShape& b, Touches& touches,
                           Work& work);
void touches_of_mesh_core(const PlacedShape& a, const PlacedShape& b, Touches& touches, Work& work);
/// A sphere or a box and a mesh, which need not touch: no contacts then.
void touches_of_mesh_volume(const PlacedShape& a, const PlacedShape& b, Touches& touches,
                            Work& work);
/// Two meshes, likewise.
void touches_of_meshes(const PlacedShape& a, const PlacedShape& b, Touches& touches, Work& work);
/// Likewise, where triangles go through each other. False if that does not tell.
bool touches_of_crossings(const PlacedShape& a, const PlacedShape& b, Touches& touches, Work& work);

}  // namespace graze
