#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/narrowphase/derived/common_points.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/triangle_intersection.h>
#include <algorithm>

namespace graze {
namespace {

IntersectionKind kind_of(int count) {
  if (count == 0) return IntersectionKind::None;
  if (count == 1) return IntersectionKind::Point;
  return count == 2 ? IntersectionKind::Segment : IntersectionKind::Polygon;
}

}  // namespace

TriangleIntersection intersection(const Triangle& triangle_a, const Triangle& triangle_b) {
  return bvh::in_standard_arithmetic([&]() -> TriangleIntersection {
    narrowphase::check_finite(triangle_a, "triangle A");
    narrowphase::check_finite(triangle_b, "triangle B");
    const narrowphase::OrderedTriangles triangles = narrowphase::ordered(triangle_a, triangle_b);
    const narrowphase::CommonPoints common = narrowphase::find_common_points(triangles);
    TriangleIntersection result;
    result.kind = kind_of(common.count);
    result.count = common.count;
    for (int i = 0; i < common.count; ++i) {
      const std::array<double, 3> value = narrowphase::value_of(common.point[i], triangles);
      std::copy(value.begin(), value.end(), result.corner[i].data());
    }
    return result;
  });
}

}  // namespace graze
