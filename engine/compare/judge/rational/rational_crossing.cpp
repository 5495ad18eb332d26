#include <graze/engine/compare/judge/rational/rational_triangle.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace graze::compare {
namespace {

RationalPoint normal_of(const RationalTriangle& t) {
  return cross(edge_of(t, 0), edge_of(t, 1));
}

/// Returns how far the corners of t are on the positive side of the plane of `plane`, times its
/// area.
std::array<mpq_class, 3> heights_above(const RationalTriangle& plane, const RationalTriangle& t) {
  const RationalPoint normal = normal_of(plane);
  std::array<mpq_class, 3> heights;
  for (std::size_t i = 0; i < 3; ++i)
    heights[i] = dot(normal, minus(t[i], plane[0]));
  return heights;
}

bool is_on_both_sides(const std::array<mpq_class, 3>& heights) {
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  return *low < 0 && *high > 0;
}

/// Returns where the sides of t go through the plane, or have an end in it.
std::vector<RationalPoint> points_at_height_zero(const RationalTriangle& t,
                                                 const std::array<mpq_class, 3>& heights) {
  std::vector<RationalPoint> points;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (i + 1) % 3;
    if (heights[i] == 0) points.push_back(t[i]);
    if (sgn(heights[i]) * sgn(heights[k]) >= 0) continue;
    const mpq_class share = heights[i] / (heights[i] - heights[k]);
    const RationalPoint offset = edge_of(t, i);
    points.push_back(
        {t[i][0] + share * offset[0], t[i][1] + share * offset[1], t[i][2] + share * offset[2]});
  }
  return points;
}

struct OpenInterval {
  mpq_class low;
  mpq_class high;
};

/// Returns the cut of a triangle with area, which a plane has on both sides, along a direction of
/// the plane.
OpenInterval cut_along(const RationalPoint& direction, const RationalTriangle& t,
                       const std::array<mpq_class, 3>& heights) {
  std::vector<mpq_class> values;
  for (const RationalPoint& p : points_at_height_zero(t, heights))
    values.push_back(dot(direction, p));
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low, *high};
}

/// True if a segment, whose three corners are on one line, pierces a triangle with area.
bool does_pierce(const RationalTriangle& segment, const RationalTriangle& t) {
  const std::array<mpq_class, 3> heights = heights_above(t, segment);
  if (!is_on_both_sides(heights)) return false;
  const RationalPoint normal = normal_of(t);
  const RationalPoint point = points_at_height_zero(segment, heights).front();
  for (std::size_t i = 0; i < 3; ++i) {
    if (dot(normal, cross(edge_of(t, i), minus(point, t[i]))) <= 0) return false;
  }
  return true;
}

}  // namespace

bool are_coplanar(const RationalTriangle& a, const RationalTriangle& b) {
  std::array<RationalPoint, 5> offsets = {minus(a[1], a[0]), minus(a[2], a[0]), minus(b[0], a[0]),
                                          minus(b[1], a[0]), minus(b[2], a[0])};
  const auto first = std::find_if_not(offsets.begin(), offsets.end(), is_zero);
  if (first == offsets.end()) return true;
  RationalPoint normal{};
  for (const RationalPoint& offset : offsets) {
    if (is_zero(normal)) normal = cross(*first, offset);
    if (dot(normal, offset) != 0) return false;
  }
  // A normal that was found late must hold for those before it, too.
  return std::all_of(offsets.begin(), offsets.end(),
                     [&](const RationalPoint& offset) { return dot(normal, offset) == 0; });
}

bool do_cross(const RationalTriangle& a, const RationalTriangle& b) {
  const bool is_flat_a = has_no_area(a);
  const bool is_flat_b = has_no_area(b);
  if (is_flat_a && is_flat_b) return false;  // segments and points that meet lie in one plane
  if (is_flat_a) return does_pierce(a, b);
  if (is_flat_b) return does_pierce(b, a);
  const std::array<mpq_class, 3> heights_a = heights_above(b, a);
  const std::array<mpq_class, 3> heights_b = heights_above(a, b);
  if (!is_on_both_sides(heights_a) || !is_on_both_sides(heights_b)) return false;
  const RationalPoint direction = cross(normal_of(a), normal_of(b));
  const OpenInterval cut_a = cut_along(direction, a, heights_a);
  const OpenInterval cut_b = cut_along(direction, b, heights_b);
  return cut_a.low < cut_b.high && cut_b.low < cut_a.high;
}

}  // namespace graze::compare
