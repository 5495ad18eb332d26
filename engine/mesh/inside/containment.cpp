#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/containment.h>
#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query/query_results.h>

#include <cmath>
#include <string>

namespace graze {
namespace {

bool is_within(const Aabb& box, const Eigen::Vector3d& point) {
  bool is_inside = true;
  for (int k = 0; k < 3; ++k) {
    is_inside &= box.min.data()[k] <= point.data()[k] && point.data()[k] <= box.max.data()[k];
  }
  return is_inside;
}

}  // namespace

void check_point(const Eigen::Vector3d& point, const std::string& what) {
  for (int k = 0; k < 3; ++k) {
    if (!std::isfinite(point.data()[k])) {
      throw InputError(what + ": coordinate " + "xyz"[k] + " is not finite");
    }
  }
}

bool contains(const PlacedMeshView& placed, const Eigen::Vector3d& point, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    check_point(point, "point");
    check_placement(placed.pose, placed.mesh.bounds(), "pose of the mesh");
    check_closed(placed.mesh, "the mesh");
    // The identity changes no vertex (law 1), and a mesh that stays where it was needs no frames.
    const bool is_in_place = placed.pose.matrix() == Eigen::Matrix4d::Identity();
    if (is_in_place && !is_within(placed.mesh.bounds(), point)) return false;
    CountedWork counted(work);
    return is_in_place ? is_on_or_enclosed(placed.mesh, point, counted.work())
                       : is_on_or_enclosed(placed, point, counted.work());
  });
}

}  // namespace graze
