#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/narrowphase/derived/common_points.h>
#include <graze/narrowphase/derived/distance_stages.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <algorithm>
#include <cmath>

namespace graze {
namespace narrowphase {
namespace {

Eigen::Vector3d as_vector(const std::array<double, 3>& p) {
  return {p[0], p[1], p[2]};
}

/// Returns the result in the order in which the triangles were given.
TriangleDistance result_of(const OrderedTriangles& t, const Witness& witness, Feature feature_a,
                           Feature feature_b) {
  TriangleDistance result{witness.distance, as_vector(witness.point_a), as_vector(witness.point_b),
                          feature_a, feature_b};
  if (t.is_swapped) {
    std::swap(result.point_a, result.point_b);
    std::swap(result.feature_a, result.feature_b);
  }
  return result;
}

Feature feature_of(unsigned edges) {
  if (edges == 0) return Feature::Face;
  return (edges & (edges - 1)) == 0 ? Feature::Edge : Feature::Vertex;
}

TriangleDistance at_common_point(const OrderedTriangles& t, const CommonPoint& point) {
  const std::array<double, 3> value = value_of(point, t);
  return result_of(t, {0, value, value}, feature_of(point.edges_a), feature_of(point.edges_b));
}

TriangleDistance distance_exactly(const OrderedTriangles& t) {
  const CommonPoints common = find_common_points(t);
  if (common.count > 0) return at_common_point(t, common.point[0]);
  const FeaturePair pair = find_nearest_exactly(t);
  return result_of(t, exact_witness(t, pair), pair.kind_a, pair.kind_b);
}

}  // namespace

StagedDistance decide_distance(const Triangle& triangle_a, const Triangle& triangle_b) {
  const OrderedTriangles t = ordered(triangle_a, triangle_b);
  // A coordinate that is not finite passes no filter.
  if (const auto pair = find_surely_nearest(t)) {
    if (const auto witness = rounded_witness(t, *pair)) {
      return {result_of(t, *witness, pair->kind_a, pair->kind_b), Stage::Triage};
    }
    check_finite(triangle_a, "triangle A");
    check_finite(triangle_b, "triangle B");
    return {result_of(t, exact_witness(t, *pair), pair->kind_a, pair->kind_b), Stage::Exact};
  }
  check_finite(triangle_a, "triangle A");
  check_finite(triangle_b, "triangle B");
  return {distance_exactly(t), Stage::Exact};
}

TriangleDistance distance_exactly(const Triangle& triangle_a, const Triangle& triangle_b) {
  check_finite(triangle_a, "triangle A");
  check_finite(triangle_b, "triangle B");
  return distance_exactly(ordered(triangle_a, triangle_b));
}

}  // namespace narrowphase

TriangleDistance distance(const Triangle& triangle_a, const Triangle& triangle_b) {
  return bvh::in_standard_arithmetic([&]() -> TriangleDistance {
    return narrowphase::decide_distance(triangle_a, triangle_b).result;
  });
}

}  // namespace graze
