#include <graze/engine/mesh/rigid/near_triangles.h>
#include <graze/narrowphase/derived/distance_stages.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <cmath>

namespace graze {
namespace {

/// Sets the direction from one point to another. Returns false if they are so near that it has
/// none.
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

/// Sets the direction between what look like the nearest points. Any direction is possible, most
/// are right: it proves nothing before it is used in a proof.
bool guess_direction(const Triangle& a, const Triangle& b, ApartDirection& direction) {
  const narrowphase::OrderedTriangles ordered = narrowphase::ordered(a, b);
  const auto witness = narrowphase::rounded_witness(ordered, narrowphase::guess_nearest(ordered));
  if (!witness) return false;
  return ordered.is_swapped ? set_direction(direction, witness->point_b, witness->point_a)
                            : set_direction(direction, witness->point_a, witness->point_b);
}

}  // namespace

/// Sets the direction to the normal of a triangle at that pose, from A to B. Returns false if
/// neither way has the two further apart than the limit.
bool MovingTriangles::set_to_normal(const PlacedBodies& placed, const BodyTriangle& triangle,
                                    const Pose& pose, ApartDirection& direction) const {
  double edge[2][3], own[3];
  for (int i = 0; i < 3; ++i) {
    edge[0][i] = triangle.corners[1][i] - triangle.corners[0][i];
    edge[1][i] = triangle.corners[2][i] - triangle.corners[0][i];
  }
  for (int i = 0; i < 3; ++i) {
    const int k = (i + 1) % 3, l = (i + 2) % 3;
    own[i] = edge[0][k] * edge[1][l] - edge[0][l] * edge[1][k];
  }
  const double* m = pose.data();
  double(&n)[3] = direction.n;
  for (int i = 0; i < 3; ++i)
    n[i] = (m[i] * own[0] + m[4 + i] * own[1]) + m[8 + i] * own[2];
  const double square = dot_product(n, n);
  if (!(square > 0x1p-900 && square < 0x1p900)) return false;
  const double length = std::sqrt(square);
  for (double& x : n)
    x /= length;
  const SeenDirection seen(placed, n);
  const Extent of_a = a_.along(seen.in_a), of_b = b_.along(seen.in_b);
  const double between = dot_product(n, placed.between);
  if (between + (of_b.low - of_a.high) > pair_.sure_limit()) return true;
  for (double& x : n)
    x = -x;
  return (of_a.low - of_b.high) - between > pair_.sure_limit();
}

bool MovingTriangles::are_apart_by_normals(const TimeSpan& span, std::uint64_t time,
                                           ApartDirection& direction) {
  for (const bool is_of_a : {true, false}) {
    const PlacedBodies& placed = pair_.at(time);
    const bool is_found = is_of_a ? set_to_normal(placed, a_, placed.pose_a, direction)
                                  : set_to_normal(placed, b_, placed.pose_b, direction);
    if (is_found && ask(span, direction) == Apart::Always) return true;
  }
  return false;
}

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
