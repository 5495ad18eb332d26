#include <graze/engine/world/shapes/pair_functions.h>
#include <graze/engine/world/shapes/placed_core.h>

namespace graze {

using narrowphase::Core;

namespace {

struct Cores {
  Eigen::Vector3d origin;
  Core a;
  Core b;
};

/// Returns both cores, relative to the middle of A.
Cores cores_of(const PlacedShapeView& a, const PlacedShapeView& b) {
  const Eigen::Vector3d origin = middle_of(a.shape, a.pose);
  return {origin, core_of(a.shape, a.pose, origin), core_of(b.shape, b.pose, origin)};
}

}  // namespace

bool intersect_cores(const PlacedShapeView& a, const PlacedShapeView& b, Work& work) {
  const Cores cores = cores_of(a, b);
  PairStatus status{};
  const bool is_apart = are_apart(cores.a, cores.b, status);
  ++work.convex_tests;
  work.convex_failures += status == PairStatus::NotConverged;
  return !is_apart;
}

ShapeDistance distance_of_cores(const PlacedShapeView& a, const PlacedShapeView& b, Work& work) {
  const Cores cores = cores_of(a, b);
  const SetGap gap = gap_of_sets(cores.a, cores.b);
  ++work.convex_tests;
  work.convex_failures += gap.status == PairStatus::NotConverged;
  return {gap.distance,
          gap.lower,
          in_world(gap.point_a, cores.origin),
          in_world(gap.point_b, cores.origin),
          to_eigen(gap.normal),
          gap.status};
}

}  // namespace graze
