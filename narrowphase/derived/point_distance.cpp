// The nearest point of a convex set is unique, so that any feature that holds it will do: rounded
// arithmetic guesses one, signs with bounds prove it, and where they cannot the exact stages of two
// triangles decide.

#include <graze/narrowphase/derived/distance_stages.h>
#include <graze/narrowphase/derived/optimality.h>
#include <graze/narrowphase/derived/point_distance.h>
#include <graze/narrowphase/predicates/predicates.h>

#include <algorithm>
#include <functional>

namespace graze::narrowphase {
namespace {

/// A claim about the triangle holds where its sign is surely positive. A claim about other corners
/// of the point holds by itself: the point has but one corner, and the step has no length.
class PointProof {
 public:
  explicit PointProof(const TriangleCorners& point) : point_(point) {}

  bool has_length(Step p) const { return !std::equal(p.from, p.from + 3, p.to); }
  bool holds_dot(Step p, Step q) const { return is_own(p) || dot_filter(p, q) == Sign::Positive; }
  bool holds_triple(Step p, Step q, Step r) const {
    return is_own(r) || triple_filter(p, q, r) == Sign::Positive;
  }
  bool holds_cross_products(Step p, Step q, Step r, Step s) const {
    return is_own(s) || crosses_filter(p, q, r, s) == Sign::Positive;
  }
  Sign side(Step p, Step q, Step r) const { return triple_filter(p, q, r).value_or(Sign::Zero); }

 private:
  bool is_of_point(const double* corner) const {
    return std::find(std::begin(corners_), std::end(corners_), corner) != std::end(corners_);
  }
  bool is_own(Step step) const { return is_of_point(step.from) && is_of_point(step.to); }

  const TriangleCorners& point_;
  const double* corners_[3] = {point_[0], point_[1], point_[2]};
};

struct Guess {
  Feature kind;
  int index;
};

/// Guesses as Ericson, "Real-Time Collision Detection" (2005), 5.1.5, does, on corners b in
/// ascending order. Any answer is possible, most are right.
Guess guess_nearest(const double* p, const TriangleCorners& y) {
  double ab[3], ac[3], ap[3];
  for (int k = 0; k < 3; ++k)
    ab[k] = y[1][k] - y[0][k], ac[k] = y[2][k] - y[0][k], ap[k] = p[k] - y[0][k];
  const auto dot = [](const double* s, const double* t) {
    return s[0] * t[0] + s[1] * t[1] + s[2] * t[2];
  };
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  const double ab_ab = dot(ab, ab), ab_ac = dot(ab, ac), ac_ac = dot(ac, ac);
  const double d3 = d1 - ab_ab, d4 = d2 - ab_ac;  // of p - b
  const double d5 = d1 - ab_ac, d6 = d2 - ac_ac;  // of p - c
  if (d1 <= 0 && d2 <= 0) return {Feature::Vertex, 0};
  if (d3 >= 0 && d4 <= d3) return {Feature::Vertex, 1};
  if (d6 >= 0 && d5 <= d6) return {Feature::Vertex, 2};
  if (d1 >= 0 && d3 <= 0 && d1 * d4 - d3 * d2 <= 0) return {Feature::Edge, 0};
  if (d2 >= 0 && d6 <= 0 && d5 * d2 - d1 * d6 <= 0) return {Feature::Edge, 2};
  if (d4 - d3 >= 0 && d5 - d6 >= 0 && d3 * d6 - d5 * d4 <= 0) return {Feature::Edge, 1};
  return {Feature::Face, 0};
}

bool is_surely_nearest(const TriangleCorners& x, const TriangleCorners& y, Guess guess) {
  const PointProof proof(x);
  if (guess.kind == Feature::Vertex) return are_nearest_vertices(proof, x, 0, y, guess.index);
  if (guess.kind == Feature::Edge) return are_nearest_vertex_and_edge(proof, x, 0, y, guess.index);
  return are_nearest_vertex_and_face(proof, x, 0, y);
}

}  // namespace

PointDistance decide_distance(const Eigen::Vector3d& point, const Triangle& triangle) {
  const Triangle as_triangle{point, point, point};
  const OrderedTriangles t = ordered(as_triangle, triangle);
  const TriangleCorners& x = t.is_swapped ? t.b : t.a;
  const TriangleCorners& y = t.is_swapped ? t.a : t.b;
  const Guess guess = guess_nearest(x[0], y);
  if (is_surely_nearest(x, y, guess)) {
    const FeaturePair pair = t.is_swapped
                                 ? FeaturePair{guess.kind, guess.index, Feature::Vertex, 0}
                                 : FeaturePair{Feature::Vertex, 0, guess.kind, guess.index};
    if (const std::optional<Witness> witness = rounded_witness(t, pair)) {
      const std::array<double, 3>& nearest = t.is_swapped ? witness->point_a : witness->point_b;
      return {witness->distance, {nearest[0], nearest[1], nearest[2]}, guess.kind, Stage::Triage};
    }
  }
  const TriangleDistance found = distance_exactly(as_triangle, triangle);
  return {found.distance, found.point_b, found.feature_b, Stage::Exact};
}

}  // namespace graze::narrowphase
