#include <graze/engine/compare/judge/meshes/mesh_reviews.h>
#include <graze/engine/compare/judge/meshes/pair_error.h>
#include <graze/engine/compare/judge/rational/mesh_referee.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>

namespace graze::compare {
namespace {

using Eigen::Vector3d;
using Fault = std::optional<WitnessFault>;

double bound_of(double largest) {
  return kTouchUlps * (std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest);
}

class IntersectionReview {
 public:
  IntersectionReview(const MeshReferee& referee, const std::vector<TrianglePair>& hits,
                     const CaseIntersection& intersection)
      : referee_(referee),
        hits_(hits),
        points_(intersection.points),
        is_named_(points_.size()),
        bound_(bound_of(largest_coordinate(referee))) {}

  Fault fault_of_part(std::span<const std::uint32_t> corners, std::span<const TrianglePair> pairs) {
    if (pairs.empty()) return WitnessFault{"a part of no pair", 0};
    for (const std::uint32_t corner : corners) {
      if (corner >= points_.size()) return WitnessFault{"a point that is not there", 0};
      is_named_[corner] = true;
    }
    for (const TrianglePair& pair : pairs) {
      if (!std::binary_search(hits_.begin(), hits_.end(), pair))
        return WitnessFault{"a pair that does not hit", 0};
      named_.insert({pair.a, pair.b});
      for (const std::uint32_t corner : corners) {
        const Vector3d& p = points_[corner].position;
        const double off = std::max(distance_to({referee_.triangle_a(pair.a)}, p),
                                    distance_to({referee_.triangle_b(pair.b)}, p));
        if (off > bound_) return WitnessFault{"a point off its triangles", off};
      }
    }
    return std::nullopt;
  }

  Fault fault_of_rest() const {
    if (std::find(is_named_.begin(), is_named_.end(), false) != is_named_.end())
      return WitnessFault{"a point of no part", 0};
    for (const TrianglePair& pair : hits_) {
      if (named_.count({pair.a, pair.b}) != 0) continue;
      if (do_cross(exactly(referee_.triangle_a(pair.a)), exactly(referee_.triangle_b(pair.b))))
        return WitnessFault{"a pair that crosses is missing", 0};
    }
    return std::nullopt;
  }

 private:
  const MeshReferee& referee_;
  const std::vector<TrianglePair>& hits_;
  const std::vector<IntersectionPoint>& points_;
  std::vector<bool> is_named_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> named_;
  double bound_;
};

}  // namespace

PartsReview review_intersection(const MeshReferee& referee, const std::vector<TrianglePair>& hits,
                                const CaseIntersection& intersection) {
  IntersectionReview review(referee, hits, intersection);
  for (const CaseIntersection::Curve& curve : intersection.curves) {
    for (const CaseIntersection::Segment& segment : curve.segments) {
      const std::array<std::uint32_t, 2> ends = {segment.from, segment.to};
      if (Fault fault = review.fault_of_part(ends, segment.pairs)) return {.fault = fault};
    }
  }
  for (const auto& patch : intersection.patches) {
    for (const CaseIntersection::Polygon& polygon : patch) {
      if (Fault fault = review.fault_of_part(polygon.corners, polygon.pairs))
        return {.fault = fault};
    }
  }
  for (const CaseIntersection::Touch& touch : intersection.touching_points) {
    const std::array<std::uint32_t, 1> point = {touch.point};
    if (Fault fault = review.fault_of_part(point, touch.pairs)) return {.fault = fault};
  }
  if (Fault fault = review.fault_of_rest()) return {.fault = fault};
  return {.unjudged = "features, and how its parts are joined"};
}

PartsReview review_corners(const Triangle& a, const Triangle& b,
                           const std::vector<Vector3d>& corners) {
  if (corners.empty()) return {};
  double largest = 0;
  for (const Vector3d* p : {&a.a, &a.b, &a.c, &b.a, &b.b, &b.c})
    largest = std::max(largest, p->cwiseAbs().maxCoeff());
  const double bound = bound_of(largest);
  for (const Vector3d& corner : corners) {
    const double off = std::max(distance_to({a}, corner), distance_to({b}, corner));
    if (off > bound) return {.fault = WitnessFault{"a corner off the triangles", off}};
  }
  std::vector<Triangle> polygon;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t k = i; k < corners.size(); ++k)
      polygon.push_back({corners[0], corners[i], corners[k]});
  }
  for (const Triangle* t : {&a, &b}) {
    for (const Vector3d& p : {t->a, t->b, t->c}) {
      if (distance_to({t == &a ? b : a}, p) > 0) continue;  // no corner of the intersection
      const double off = distance_to(polygon, p);
      if (off > bound) return {.fault = WitnessFault{"a corner is missing", off}};
    }
  }
  return {.unjudged = "the order of its corners, and those where sides cross"};
}

}  // namespace graze::compare
