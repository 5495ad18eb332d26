#include <graze/bvh/pose.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/rigid/moving_shape.h>
#include <graze/engine/world/rigid/tree_sweep.h>

#include <algorithm>

namespace graze {

// In the mesh's frame the shift is R^T times the shift in the world, off by 3 dev of its length if
// R is no rotation, and by rounding.
TreeSweep::TreeSweep(const MeshDescent& descent, const PlacedMeshView& mesh,
                     const Eigen::Vector3d& shift, double room)
    : tree_(descent.tree()), mesh_(mesh.mesh), unit_(descent.tree().frame.unit()) {
  const double slack = (8 * rotation_deviation(mesh.pose) + 0x1p-45) * length_of(shift);
  const double around = (room + slack) * MovingShape::kStretch / unit_;
  const double* m = mesh.pose.data();  // column-major 4x4
  const double* s = shift.data();
  for (int k = 0; k < 3; ++k) {
    sweep_.shift[k] = ((m[4 * k] * s[0] + m[4 * k + 1] * s[1]) + m[4 * k + 2] * s[2]) / unit_;
    sweep_.min[k] = descent.min()[k] - around;
    sweep_.max[k] = descent.max()[k] + around;
  }
}

NearTimes TreeSweep::of_triangle(std::uint32_t index) const {
  const Triangle triangle = mesh_.triangle(index);
  double low[3];
  double high[3];
  for (int k = 0; k < 3; ++k) {
    const double a = triangle.a.data()[k], b = triangle.b.data()[k], c = triangle.c.data()[k];
    low[k] = (std::min(a, std::min(b, c)) - tree_.frame.centre[k]) / unit_;
    high[k] = (std::max(a, std::max(b, c)) - tree_.frame.centre[k]) / unit_;
  }
  return sweep_.of(low, high);
}

}  // namespace graze
