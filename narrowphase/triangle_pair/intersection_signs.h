#pragma once

// Whether two closed triangles share a point: Guigue and Devillers' test by exact signs, for
// coordinates that are doubles, or integers (fixed_point.h), and all that it leaves out: triangles
// in one plane, segments and points.

#include <graze/narrowphase/predicates/coplanar.h>
#include <graze/narrowphase/predicates/sides_of_plane.h>
#include <utility>

namespace graze::narrowphase {

/// Whether two triangles with area in different planes share a point (Guigue and Devillers, section
/// 3).
template <typename Number>
bool meet_in_space(const Corners<Number>& a, const Corners<Number>& b, const PlaneSides& sides_a,
                   const PlaneSides& sides_b) {
  const Apex apex_a = find_apex(sides_a.sign);
  const Apex apex_b = find_apex(sides_b.sign);
  const Number* p_a = a.point[apex_a.index];
  const Number* q_a = a.point[(apex_a.index + 1) % 3];
  const Number* r_a = a.point[(apex_a.index + 2) % 3];
  const Number* p_b = b.point[apex_b.index];
  const Number* q_b = b.point[(apex_b.index + 1) % 3];
  const Number* r_b = b.point[(apex_b.index + 2) % 3];
  // Turn each triangle so that the other's apex is on its positive side.
  if (apex_b.side == Sign::Negative) std::swap(q_a, r_a);
  if (apex_a.side == Sign::Negative) std::swap(q_b, r_b);
  return orientation_3d(p_a, q_a, p_b, q_b) != Sign::Positive &&
         orientation_3d(p_a, r_a, r_b, p_b) != Sign::Positive;
}

/// Whether a closed segment that is not in the plane of a triangle with area shares a point with
/// that triangle: so it does if its ends are not strictly on one side of the plane and its line
/// passes no two of the edges on different sides.
template <typename Number>
bool segment_meets(const Number* u, Sign side_u, const Number* v, Sign side_v,
                   const Corners<Number>& triangle) {
  if (side_u == side_v) return false;
  bool has_positive = false;
  bool has_negative = false;
  for (int i = 0; i < 3; ++i) {
    const Sign sign = orientation_3d(u, v, triangle.point[i], triangle.point[(i + 1) % 3]);
    has_positive |= sign == Sign::Positive;
    has_negative |= sign == Sign::Negative;
  }
  return !(has_positive && has_negative);
}

/// Whether a triangle with area shares a point with one without, which is the union of its edges.
/// `sides` are those of the latter's vertices, not all in the plane nor all on one side of it.
template <typename Number>
bool any_edge_meets(const Corners<Number>& without_area, const PlaneSides& sides,
                    const Corners<Number>& triangle) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (segment_meets(without_area.point[i], sides.sign[i], without_area.point[j], sides.sign[j],
                      triangle)) {
      return true;
    }
  }
  return false;
}

template <typename Number>
bool any_edges_meet(const Corners<Number>& a, const Corners<Number>& b) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (segments_intersect(a.point[i], a.point[(i + 1) % 3], b.point[j], b.point[(j + 1) % 3])) {
        return true;
      }
    }
  }
  return false;
}

/// The same for two triangles in one plane, or of which at least one has no area.
template <typename Number>
bool meet_in_plane_or_without_area(const Corners<Number>& a, const Corners<Number>& b,
                                   const PlaneSides& sides_a, const PlaneSides& sides_b) {
  const int axis_a = projection_axis(a);
  const int axis_b = projection_axis(b);
  if (axis_a < 0 && axis_b < 0) return any_edges_meet(a, b);
  if (axis_a < 0 && !sides_a.are_all_zero()) return any_edge_meets(a, sides_a, b);
  if (axis_b < 0 && !sides_b.are_all_zero()) return any_edge_meets(b, sides_b, a);
  return projections_intersect(a, b, axis_a >= 0 ? axis_a : axis_b);
}

/// True if and only if the two closed triangles share a point.
template <typename Number>
bool meet_exactly(const Corners<Number>& a, const Corners<Number>& b) {
  const PlaneSides sides_a = sides_of_plane(b, a);
  if (sides_a.are_equal() && !sides_a.are_all_zero()) return false;
  const PlaneSides sides_b = sides_of_plane(a, b);
  if (sides_b.are_equal() && !sides_b.are_all_zero()) return false;
  // A triangle without area puts every vertex of the other in its plane: from here on, unless one
  // set of signs is all zero, both have area and their planes differ.
  if (sides_a.are_all_zero() || sides_b.are_all_zero()) {
    return meet_in_plane_or_without_area(a, b, sides_a, sides_b);
  }
  return meet_in_space(a, b, sides_a, sides_b);
}

}  // namespace graze::narrowphase
