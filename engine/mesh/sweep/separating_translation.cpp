#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/mesh_contacts.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/separating_translation.h>
#include <graze/engine/mesh/sweep/last_contact.h>
#include <graze/engine/mesh/sweep/sweep.h>

#include <limits>
#include <vector>

namespace graze {
namespace {

SeparatingTranslation separation_of(double distance, const Eigen::Vector3d& direction,
                                    const Pose& pose_b) {
  SeparatingTranslation separation{distance, direction, {}, pose_b};
  for (int k = 0; k < 3; ++k) {
    separation.translation.data()[k] = distance * direction.data()[k];
    separation.pose_b.data()[12 + k] += separation.translation.data()[k];
  }
  return separation;
}

/// Lengthens the distance until the exact test, which has the last word, says that the meshes are
/// apart: the bound covers all rounding, but is not trusted. Steps double, so that they end even
/// where the first vanish in the pose's translation.
SeparatingTranslation end_contact(const PlacedMeshView& a, const PlacedMeshView& b,
                                  const Eigen::Vector3d& direction, double distance, Work& work) {
  SeparatingTranslation separation = separation_of(distance, direction, b.pose);
  double step = 0x1p-48 * distance + std::numeric_limits<double>::denorm_min();
  for (; intersects(a, {b.mesh, separation.pose_b}, &work); step *= 2) {
    distance += step;
    separation = separation_of(distance, direction, b.pose);
  }
  return separation;
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kTriedContacts = 4;

/// Returns directions, each of which is tried both ways.
std::vector<Eigen::Vector3d> candidates(const PlacedMeshView& a, const PlacedMeshView& b,
                                        Work& work) {
  std::vector<Eigen::Vector3d> directions;
  for (const MeshContact& contact : find_contacts(a, b, {.limit = kTriedContacts}, &work))
    directions.push_back(contact.normal);
  const Eigen::Vector3d from = contacts::middle_of(a);
  const Eigen::Vector3d to = contacts::middle_of(b);
  Eigen::Vector3d between;
  bool is_zero = true;
  for (int k = 0; k < 3; ++k) {
    between.data()[k] = 0.5 * to.data()[k] - 0.5 * from.data()[k];
    is_zero = is_zero && between.data()[k] == 0;
  }
  if (!is_zero) directions.push_back(contacts::unit_direction(between));
  directions.insert(directions.end(), {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  return directions;
}

}  // namespace

SeparatingTranslation separating_translation(const PlacedMeshView& mesh_a,
                                             const PlacedMeshView& mesh_b,
                                             const Eigen::Vector3d& direction, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> SeparatingTranslation {
    CountedWork counted(work);
    check_placement(mesh_a.pose, mesh_a.mesh.bounds(), "pose of mesh A");
    check_placement(mesh_b.pose, mesh_b.mesh.bounds(), "pose of mesh B");
    const Eigen::Vector3d unit = contacts::unit_direction(direction);
    const double distance = contacts::last_contact(mesh_a, mesh_b, unit, kInfinity, counted.work());
    return end_contact(mesh_a, mesh_b, unit, distance, counted.work());
  });
}

SeparatingTranslation separating_translation(const PlacedMeshView& mesh_a,
                                             const PlacedMeshView& mesh_b, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> SeparatingTranslation {
    CountedWork counted(work);
    if (!intersects(mesh_a, mesh_b, &counted.work()))
      return separation_of(0, {1, 0, 0}, mesh_b.pose);
    double shortest = kInfinity;
    Eigen::Vector3d best;
    for (const Eigen::Vector3d& direction : candidates(mesh_a, mesh_b, counted.work())) {
      const double* d = direction.data();
      for (const Eigen::Vector3d& signed_direction :
           {direction, Eigen::Vector3d(-d[0], -d[1], -d[2])}) {
        const double distance =
            contacts::last_contact(mesh_a, mesh_b, signed_direction, shortest, counted.work());
        if (distance >= shortest) continue;
        shortest = distance;
        best = signed_direction;
      }
    }
    return end_contact(mesh_a, mesh_b, best, shortest, counted.work());
  });
}

}  // namespace graze
