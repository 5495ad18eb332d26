#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/cases/case_intersection.h>

#include <algorithm>

namespace graze {
namespace {

bool is_same_point(const IntersectionPoint& a, const IntersectionPoint& b) {
  return a.position == b.position && a.feature_a == b.feature_a && a.feature_b == b.feature_b;
}

}  // namespace

CaseIntersection in_parts(const MeshIntersection& whole) {
  const auto pairs_of = [&](const auto& part) {
    const auto pairs = whole.pairs_of(part);
    return std::vector<TrianglePair>(pairs.begin(), pairs.end());
  };
  CaseIntersection parts;
  parts.points = whole.points;
  for (const IntersectionCurve& curve : whole.curves) {
    CaseIntersection::Curve& to = parts.curves.emplace_back();
    to.is_closed = curve.is_closed;
    for (const IntersectionSegment& segment : whole.segments_of(curve))
      to.segments.push_back({segment.from, segment.to, pairs_of(segment)});
  }
  for (const IntersectionPatch& patch : whole.patches) {
    std::vector<CaseIntersection::Polygon>& to = parts.patches.emplace_back();
    for (const IntersectionPolygon& polygon : whole.polygons_of(patch)) {
      const auto* corners = polygon.corners.data();
      to.push_back({{corners, corners + polygon.corner_count}, pairs_of(polygon)});
    }
  }
  for (const TouchingPoint& touch : whole.touching_points)
    parts.touching_points.push_back({touch.point, pairs_of(touch)});
  return parts;
}

bool is_same(const CaseIntersection& a, const CaseIntersection& b) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    return std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
                      is_same_point) &&
           a.curves == b.curves && a.patches == b.patches && a.touching_points == b.touching_points;
  });
}

}  // namespace graze
