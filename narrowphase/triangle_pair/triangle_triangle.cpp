#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/predicates/coordinates.h>
#include <graze/narrowphase/predicates/coplanar.h>
#include <graze/narrowphase/predicates/fixed_point.h>
#include <graze/narrowphase/predicates/plane_sides.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/triangle_pair/crossing_stages.h>
#include <graze/narrowphase/triangle_pair/triangle_pair_batch.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>

#include <algorithm>
#include <utility>

namespace graze {

bool intersects(const Triangle& triangle_a, const Triangle& triangle_b) {
  return bvh::in_standard_arithmetic(
      [&]() -> bool { return narrowphase::decide(triangle_a, triangle_b).is_hit; });
}

namespace narrowphase {
namespace {

/// True if all coordinates are finite: zero times any other value is NaN, and so is a sum that
/// holds one.
bool is_finite(const double* corners) {
  double sum = 0;
  for (int i = 0; i < 9; ++i)
    sum += 0 * corners[i];
  return sum == 0;
}

bool shares_vertex(const double* a, const double* b) {
  bool is_shared = false;
  for (int i = 0; i < 9; i += 3) {
    for (int j = 0; j < 9; j += 3) {
      is_shared |= (a[i] == b[j]) & (a[i + 1] == b[j + 1]) & (a[i + 2] == b[j + 2]);
    }
  }
  return is_shared;
}

bool are_boxes_apart(const double* a, const double* b) {
  bool is_apart = false;
  for (int k = 0; k < 3; ++k) {
    is_apart |=
        std::max(std::max(a[k], a[k + 3]), a[k + 6]) < std::min(std::min(b[k], b[k + 3]), b[k + 6]);
    is_apart |=
        std::max(std::max(b[k], b[k + 3]), b[k + 6]) < std::min(std::min(a[k], a[k + 3]), a[k + 6]);
  }
  return is_apart;
}

// The exact stage is Guigue and Devillers' test by exact signs, for coordinates that are doubles,
// or integers (fixed_point.h), with all that the paper leaves out: triangles in one plane, segments
// and points.

/// True if two triangles with area in different planes share a point (Guigue and Devillers, section
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

/// True if a closed segment that is not in the plane of a triangle with area shares a point with
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

/// True if a triangle with area shares a point with one without, which is the union of its edges.
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

/// Decides the same for two triangles in one plane, or of which at least one has no area.
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

}  // namespace

Decision decide(const Triangle& triangle_a, const Triangle& triangle_b) {
  const Verdict verdict = triage(triangle_a, triangle_b);
  if (verdict != Verdict::Unsure) return {verdict == Verdict::Yes, Stage::Triage};
  return {intersects_exactly(triangle_a, triangle_b), Stage::Exact};
}

Verdict compare_coordinates(const Triangle& triangle_a, const Triangle& triangle_b) {
  const double* a = coordinates(triangle_a);
  const double* b = coordinates(triangle_b);
  if (!is_finite(a) || !is_finite(b)) return Verdict::Unsure;
  if (shares_vertex(a, b)) return Verdict::Yes;
  return are_boxes_apart(a, b) ? Verdict::No : Verdict::Unsure;
}

Decision decide_unsure(const Triangle& triangle_a, const Triangle& triangle_b, Touch touch) {
  check_touch(touch);
  const Verdict verdict = compare_coordinates(triangle_a, triangle_b);
  if (verdict == Verdict::No) return {false, Stage::Triage};
  if (touch == Touch::Exclude) return {crosses_exactly(triangle_a, triangle_b), Stage::Exact};
  if (verdict == Verdict::Yes) return {true, Stage::Triage};
  return {intersects_exactly(triangle_a, triangle_b), Stage::Exact};
}

bool intersects_exactly(const Triangle& triangle_a, const Triangle& triangle_b) {
  check_finite(triangle_a, "triangle A");
  check_finite(triangle_b, "triangle B");
  const double* a = coordinates(triangle_a);
  const double* b = coordinates(triangle_b);
  const double* const corners[6] = {a, a + 3, a + 6, b, b + 3, b + 6};
  FixedPoint fixed[6];
  if (to_fixed_point(corners, 6, fixed)) {
    return meet_exactly(Corners<std::int64_t>{{fixed[0], fixed[1], fixed[2]}},
                        Corners<std::int64_t>{{fixed[3], fixed[4], fixed[5]}});
  }
  return intersects_in_doubles(triangle_a, triangle_b);
}

bool intersects_in_doubles(const Triangle& triangle_a, const Triangle& triangle_b) {
  return meet_exactly(corners_of(triangle_a), corners_of(triangle_b));
}

}  // namespace narrowphase
}  // namespace graze
