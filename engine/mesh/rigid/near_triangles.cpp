#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/rigid/near_triangles.h>
#include <graze/narrowphase/derived/distance_stages.h>

#include <cmath>

namespace graze {
namespace {

/// From one point to another; false if they are so near that it has none.
template <typename Point>
bool set_direction(ApartDirection& direction, const Point& from, const Point& to) {
  double square = 0;
  for (int i = 0; i < 3; ++i) {
    direction.n[i] = to[i] - from[i];
    square += direction.n[i] * direction.n[i];
  }
  if (!(square > 0x1p-900)) return false;
  const double length = std::sqrt(square);
  for (double& x : direction.n)
    x /= length;
  return true;
}

/// From what look like the nearest points. Any direction is possible, most are right: a proof is
/// for whoever uses it.
bool guess_direction(const Triangle& a, const Triangle& b, ApartDirection& direction) {
  const narrowphase::OrderedTriangles ordered = narrowphase::ordered(a, b);
  const auto witness = narrowphase::rounded_witness(ordered, narrowphase::guess_nearest(ordered));
  if (!witness) return false;
  return ordered.is_swapped ? set_direction(direction, witness->point_b, witness->point_a)
                            : set_direction(direction, witness->point_a, witness->point_b);
}

}  // namespace

bool MovingTriangles::is_near(std::uint64_t time, ApartDirection& direction) {
  const PlacedBodies& placed = pair_.at(time);
  const Triangle a = narrowphase::place(placed.pose_a, pair_.a().mesh.triangle(indices_.a));
  const Triangle b = narrowphase::place(placed.pose_b, pair_.b().mesh.triangle(indices_.b));
  ++work_.triangle_tests;
  if (guess_direction(a, b, direction) && gap_along(placed, direction, a_, b_) > pair_.sure_limit())
    return false;
  const narrowphase::StagedDistance found = narrowphase::decide_distance(a, b);
  work_.exact_tests += found.stage == narrowphase::Stage::Exact;
  if (found.result.distance <= pair_.limit()) return true;
  set_direction(direction, found.result.point_a, found.result.point_b);
  return false;
}

}  // namespace graze
