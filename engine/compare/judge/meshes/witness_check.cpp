#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/judge/meshes/witness_check.h>
#include <graze/engine/compare/judge/rational/mesh_referee.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>

#include <cmath>
#include <limits>

namespace graze::compare {
namespace {

Triangle point_triangle(const Eigen::Vector3d& p) {
  return {p, p, p};
}

}  // namespace

std::optional<WitnessFault> fault_of_distance(const MeshReferee& referee,
                                              const MeshReferee::Gap& nearest,
                                              const CaseAnswer& answer, double tolerance) {
  if (answer.pair) {
    const mpq_class square = squared_distance(exactly(referee.triangle_a(answer.pair->a)),
                                              exactly(referee.triangle_b(answer.pair->b)));
    const double beyond = rounded_root(square) - rounded_root(nearest.square);
    if (beyond > tolerance) return WitnessFault{"the pair is not the nearest", beyond};
  }
  if (!answer.point_a || !answer.point_b) return std::nullopt;
  const Eigen::Vector3d& a = *answer.point_a;
  const Eigen::Vector3d& b = *answer.point_b;
  const double largest = largest_coordinate(referee);
  const double bound =
      kTouchUlps * (std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest);
  const double off_a = answer.pair ? distance_to({referee.triangle_a(answer.pair->a)}, a)
                                   : distance_to(referee.triangles_a(), a);
  const double off_b = answer.pair ? distance_to({referee.triangle_b(answer.pair->b)}, b)
                                   : distance_to(referee.triangles_b(), b);
  const double off_gap = root_error(
      *answer.distance, squared_distance(exactly(point_triangle(a)), exactly(point_triangle(b))));
  if (off_a > bound) return WitnessFault{"point_a is off the surface of A", off_a};
  if (off_b > bound) return WitnessFault{"point_b is off the surface of B", off_b};
  if (off_gap > bound) return WitnessFault{"the points are not so far apart", off_gap};
  return std::nullopt;
}

}  // namespace graze::compare
