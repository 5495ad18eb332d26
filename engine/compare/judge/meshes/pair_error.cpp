#include <graze/engine/compare/judge/classics/blame.h>
#include <graze/engine/compare/judge/meshes/pair_error.h>
#include <graze/engine/compare/judge/rational/box_tree.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>
#include <graze/engine/mesh/placement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
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

/// Names ways of placing, by which an answer may be another: with real numbers, and with B brought
/// into A's frame by one pose made of two, or A into B's, in double, as most engines do.
enum class Placing { Real, BIntoA, AIntoB };
constexpr std::array kPlacings = {Placing::Real, Placing::BIntoA, Placing::AIntoB};

bool is_finite(const Triangle& t) {
  return t.a.allFinite() && t.b.allFinite() && t.c.allFinite();
}

/// Returns whether the two hit by this way of placing, and nothing where it leads out of the range
/// of double.
std::optional<bool> is_hit_by(Placing placing, const PosedTriangles& posed) {
  if (placing == Placing::Real) {
    return squared_distance(placed_without_rounding(posed.pose_a, posed.a),
                            placed_without_rounding(posed.pose_b, posed.b)) == 0;
  }
  const bool is_a_moved = placing == Placing::AIntoB;
  const PlacedTriangles placed =
      placed_in(is_a_moved ? PosedTriangles{posed.b, posed.pose_b, posed.a, posed.pose_a} : posed,
                ClassicFrame::OfA, ClassicNumbers::Double);
  if (!is_finite(placed.a) || !is_finite(placed.b)) return std::nullopt;
  return squared_distance(exactly(placed.a), exactly(placed.b)) == 0;
}

PosedTriangles posed(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                     const TrianglePair& pair) {
  return {mesh_a.mesh.triangle(pair.a), mesh_a.pose, mesh_b.mesh.triangle(pair.b), mesh_b.pose};
}

/// Returns triangles whose boxes hold the placed ones of all ways, whichever frame they are brought
/// into and back from: some twenty operations, none on numbers larger than the sum here, and what a
/// pose deviates from a rotation.
std::vector<Triangle> boxes_of(const PlacedMeshView& mesh, const PlacedMeshView& other) {
  double largest = 0;
  for (const PlacedMeshView* each : {&mesh, &other}) {
    for (const Eigen::Vector3d& vertex : each->mesh.vertices())
      largest = std::max(largest, vertex.cwiseAbs().maxCoeff());
    largest = std::max(largest, each->pose.translation().cwiseAbs().maxCoeff());
  }
  double askew = 0x1p-45;
  for (const PlacedMeshView* each : {&mesh, &other}) {
    const Eigen::Matrix3d turned = each->pose.linear();
    askew += (turned.transpose() * turned - Eigen::Matrix3d::Identity()).norm();
  }
  const double slack = 8 * askew * largest;
  std::vector<Triangle> boxes;
  boxes.reserve(mesh.mesh.triangles().size());
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
  std::array<bool, kPlacings.size()> is_apart;
  is_apart.fill(true);
  const auto is_any_apart = [&] {
    return std::any_of(is_apart.begin(), is_apart.end(), [](bool apart) { return apart; });
  };
  BoxTree::for_each_overlap(BoxTree(boxes_of(mesh_a, mesh_b)), BoxTree(boxes_of(mesh_b, mesh_a)),
                            [&](std::uint32_t a, std::uint32_t b) {
                              const PosedTriangles two = posed(mesh_a, mesh_b, {a, b});
                              for (std::size_t i = 0; i < kPlacings.size(); ++i)
                                is_apart[i] =
                                    is_apart[i] && !is_hit_by(kPlacings[i], two).value_or(true);
                              return is_any_apart();
                            });
  return is_any_apart();
}

bool is_due_to_placing(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                       const TrianglePair& pair, bool is_hit) {
  if (!moves(mesh_a.pose) && !moves(mesh_b.pose)) return false;
  const PosedTriangles two = posed(mesh_a, mesh_b, pair);
  return std::any_of(kPlacings.begin(), kPlacings.end(), [&](Placing placing) {
    return is_hit_by(placing, two).value_or(is_hit) != is_hit;
  });
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
                     const TrianglePair& pair, bool is_hit,
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
      [&] { return is_due_to_placing(mesh_a, mesh_b, pair, is_hit); }, is_containment);
  return result;
}

}  // namespace graze::compare
