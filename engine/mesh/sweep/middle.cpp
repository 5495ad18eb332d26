#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/sweep/middle.h>

namespace graze::contacts {

Eigen::Vector3d middle_of(const PlacedMeshView& placed) {
  const Aabb& box = placed.mesh.bounds();
  Eigen::Vector3d middle;
  for (int k = 0; k < 3; ++k)
    middle.data()[k] = 0.5 * box.min.data()[k] + 0.5 * box.max.data()[k];
  return narrowphase::place(placed.pose, middle);
}

}  // namespace graze::contacts
