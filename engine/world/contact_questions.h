#pragma once

// What each row of the table of pairs offers as contacts; A's kind is not above B's, and points are
// relative to the origin that is handed back. Private to engine/world.

#include <graze/engine/world/pair_input.h>
#include <graze/narrowphase/convex/touches.h>

#include <vector>

namespace graze {

struct Touches {
  Eigen::Vector3d origin;
  std::vector<narrowphase::ContactPoint> list;
};

Touches touches_of_cores(const PlacedShape& a, const PlacedShape& b, Work& work);
Touches touches_with_plane(const PlacedShape& a, const PlacedShape& b);
Touches touches_of_mesh_plane(const PlacedShape& a, const PlacedShape& b, Work& work);
Touches touches_of_mesh_core(const PlacedShape& a, const PlacedShape& b, Work& work);
Touches touches_of_meshes(const PlacedShape& a, const PlacedShape& b, Work& work);

}  // namespace graze
