#include <graze/engine/mesh/contacts/last_contact.h>
#include <graze/engine/mesh/contacts/separation.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query_results.h>

#include <limits>

namespace graze {
namespace {

Separation separation_of(double distance, const Eigen::Vector3d& direction, const Pose& pose_b) {
  Separation separation{distance, direction, {}, pose_b};
  for (int k = 0; k < 3; ++k) {
    separation.translation.data()[k] = distance * direction.data()[k];
    separation.pose_b.data()[12 + k] += separation.translation.data()[k];
  }
  return separation;
}

}  // namespace

Separation separating_translation(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b,
                                  const Eigen::Vector3d& direction, Work* work) {
  CountedWork counted(work);
  check_placement(mesh_a.pose, mesh_a.mesh.bounds(), "pose of mesh A");
  check_placement(mesh_b.pose, mesh_b.mesh.bounds(), "pose of mesh B");
  const Eigen::Vector3d unit = contacts::unit_direction(direction);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double distance = contacts::last_contact(mesh_a, mesh_b, unit, kInfinity, counted.work());
  Separation separation = separation_of(distance, unit, mesh_b.pose);
  // The bound covers all rounding. It is not trusted: the exact test has the last word.
  while (intersects(mesh_a, {mesh_b.mesh, separation.pose_b}, &counted.work())) {
    distance += 0x1p-48 * distance + std::numeric_limits<double>::denorm_min();
    separation = separation_of(distance, unit, mesh_b.pose);
  }
  return separation;
}

}  // namespace graze
