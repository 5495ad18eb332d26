#include <graze/engine/compare/judge/meshes/pair_error.h>
#include <graze/engine/compare/judge/rational/box_tree.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>
#include <graze/engine/mesh/placement.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace graze::compare {
namespace {

double largest(const Triangle& t) {
  return std::max(
      {t.a.cwiseAbs().maxCoeff(), t.b.cwiseAbs().maxCoeff(), t.c.cwiseAbs().maxCoeff()});
}

bool moves(const Pose& pose) {
  return pose.matrix() != Pose::Identity().matrix();
}

/// Triangles whose boxes hold the placed ones with and without law 1's rounding: six operations,
/// none on numbers larger than the sum here.
std::vector<Triangle> boxes_of(const PlacedMeshView& mesh) {
  double largest = 0;
  for (const Eigen::Vector3d& vertex : mesh.mesh.vertices())
    largest = std::max(largest, vertex.cwiseAbs().maxCoeff());
  const double slack = 0x1p-49 * (4 * largest + mesh.pose.translation().cwiseAbs().maxCoeff());
  std::vector<Triangle> boxes;
  for (std::size_t i = 0; i < mesh.mesh.triangles().size(); ++i) {
    const Triangle t = place(mesh.pose, mesh.mesh.triangle(i));
    const Eigen::Vector3d max = t.a.cwiseMax(t.b).cwiseMax(t.c).array() + slack;
    boxes.push_back({t.a.cwiseMin(t.b).cwiseMin(t.c).array() - slack, max, max});
  }
  return boxes;
}

}  // namespace

bool is_hit_by_placing(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b) {
  if (!moves(mesh_a.pose) && !moves(mesh_b.pose)) return false;
  bool is_apart = true;
  BoxTree::for_each_overlap(
      BoxTree(boxes_of(mesh_a)), BoxTree(boxes_of(mesh_b)), [&](std::uint32_t a, std::uint32_t b) {
        is_apart =
            squared_distance(placed_without_rounding(mesh_a.pose, mesh_a.mesh.triangle(a)),
                             placed_without_rounding(mesh_b.pose, mesh_b.mesh.triangle(b))) != 0;
        return is_apart;
      });
  return is_apart;
}

bool is_due_to_placing(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                       const TrianglePair& pair, bool is_hit, const JudgeSettings& settings) {
  if (!moves(mesh_a.pose) && !moves(mesh_b.pose)) return false;
  const Triangle a = mesh_a.mesh.triangle(pair.a);
  const Triangle b = mesh_b.mesh.triangle(pair.b);
  const mpq_class gap = squared_distance(placed_without_rounding(mesh_a.pose, a),
                                         placed_without_rounding(mesh_b.pose, b));
  if ((gap == 0) != is_hit) return true;
  if (!settings.ask_again) return false;
  return settings.ask_again(place(mesh_a.pose, a), place(mesh_b.pose, b)) == is_hit;
}

double ulp_of(const Triangle& triangle_a, const Triangle& triangle_b) {
  const double value = std::max(largest(triangle_a), largest(triangle_b));
  const double next = std::nextafter(value, std::numeric_limits<double>::infinity());
  return std::isfinite(next) ? next - value : value - std::nextafter(value, 0.0);
}

ErrorClass class_of_pair(const RationalTriangle& a, const RationalTriangle& b, double ulps,
                         const std::function<bool()>& is_due_to_placing,
                         const std::function<bool()>& is_containment) {
  if (has_no_area(a) || has_no_area(b)) return ErrorClass::Degenerate;
  if (ulps <= kTouchUlps) {
    if (are_coplanar(a, b)) return ErrorClass::Coplanar;
    return is_due_to_placing && is_due_to_placing() ? ErrorClass::PoseRounding
                                                    : ErrorClass::Touching;
  }
  return is_containment && is_containment() ? ErrorClass::Containment : ErrorClass::Real;
}

PairError pair_error(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                     const TrianglePair& pair, bool is_hit, const JudgeSettings& settings,
                     const std::function<bool()>& is_containment) {
  const Triangle a = place(mesh_a.pose, mesh_a.mesh.triangle(pair.a));
  const Triangle b = place(mesh_b.pose, mesh_b.mesh.triangle(pair.b));
  const RationalTriangle exact_a = exactly(a);
  const RationalTriangle exact_b = exactly(b);
  PairError result{ErrorClass::Real, 0, 0};
  result.error =
      rounded_root(is_hit ? squared_depth(exact_a, exact_b) : squared_distance(exact_a, exact_b));
  result.ulps = result.error / ulp_of(a, b);
  result.error_class = class_of_pair(
      exact_a, exact_b, result.ulps,
      [&] { return is_due_to_placing(mesh_a, mesh_b, pair, is_hit, settings); }, is_containment);
  return result;
}

}  // namespace graze::compare
