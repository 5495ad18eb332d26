#include <graze/narrowphase/triangle_pair/placed_triangle.h>

namespace graze::narrowphase {

Eigen::Vector3d place(const Pose& pose, const Eigen::Vector3d& point) {
  const double* m = pose.data();  // column-major 4x4
  const double x = point.data()[0];
  const double y = point.data()[1];
  const double z = point.data()[2];
  Eigen::Vector3d placed;
  for (int i = 0; i < 3; ++i) {
    placed.data()[i] = ((m[i] * x + m[4 + i] * y) + m[8 + i] * z) + m[12 + i];
  }
  return placed;
}

Triangle place(const Pose& pose, const Triangle& triangle) {
  return {place(pose, triangle.a), place(pose, triangle.b), place(pose, triangle.c)};
}

}  // namespace graze::narrowphase
