// Both stages ask the same signs in the same order, the first of them of rounded orientations with
// their bound, the second of exact ones.
//
// Strict signs suffice, for this reason. The inside of a triangle with area meets a plane that does
// not hold it only if vertices lie strictly on both sides; the line that two such planes share then
// cuts an open interval of positive length out of each triangle. These overlap if and only if each
// begins before the other ends, which are the two orientations of Guigue and Devillers' figure 5,
// taken strictly: such an orientation is zero exactly where both edges meet the line in one point,
// because a plane that holds both edges and two different points of the line would be the plane of
// either triangle.

#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/predicates/coordinates.h>
#include <graze/narrowphase/predicates/orientation_stages.h>
#include <graze/narrowphase/predicates/plane_sides.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/triangle_pair/crossing_stages.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>

#include <optional>
#include <utility>

namespace graze::narrowphase {
namespace {

using Vertices = Corners<double>;

/// Returns sides_of_plane() by the filter alone, and nothing unless all signs are sure and none is
/// zero.
std::optional<PlaneSides> strict_sides_of_plane(const Vertices& plane, const Vertices& other) {
  PlaneSides sides;
  for (int i = 0; i < 3; ++i) {
    const auto sign =
        orientation_3d_filter(plane.point[0], plane.point[1], plane.point[2], other.point[i]);
    if (!sign || *sign == Sign::Zero) return std::nullopt;
    sides.sign[i] = *sign;
  }
  return sides;
}

/// A triangle seen from its apex, the others in an order in which the other triangle's
/// apex is on the positive side of its plane.
struct Canonical {
  const double* p;
  const double* q;
  const double* r;
};

Canonical canonical(const Vertices& corners, int apex, Sign other_side) {
  const double* q = corners.point[(apex + 1) % 3];
  const double* r = corners.point[(apex + 2) % 3];
  if (other_side == Sign::Negative) std::swap(q, r);
  return {corners.point[apex], q, r};
}

/// Returns two triangles, each with vertices strictly on both sides of the other's plane, as seen
/// from their apexes.
std::pair<Canonical, Canonical> canonical(const Vertices& a, const Vertices& b,
                                          const PlaneSides& sides_a, const PlaneSides& sides_b) {
  const Apex apex_a = find_apex(sides_a.sign);
  const Apex apex_b = find_apex(sides_b.sign);
  return {canonical(a, apex_a.index, apex_b.side), canonical(b, apex_b.index, apex_a.side)};
}

/// True if a triangle without area, a segment with ends on different sides of the other's plane,
/// pierces the inside of the other.
bool pierces(const Vertices& segment, const PlaneSides& sides, const Vertices& triangle) {
  const double* u = segment.point[sides.first(Sign::Negative)];
  const double* v = segment.point[sides.first(Sign::Positive)];
  const auto passes = [&](int i) {
    return orientation_3d(u, v, triangle.point[i], triangle.point[(i + 1) % 3]);
  };
  const Sign first = passes(0);
  return first != Sign::Zero && passes(1) == first && passes(2) == first;
}

}  // namespace

Verdict crossing_triage(const Triangle& triangle_a, const Triangle& triangle_b) {
  const Verdict touching = triage(triangle_a, triangle_b);
  if (touching == Verdict::No) return Verdict::No;
  const Vertices a = corners_of(triangle_a);
  const Vertices b = corners_of(triangle_b);
  const auto sides_a = strict_sides_of_plane(b, a);
  if (!sides_a) return Verdict::Unsure;
  const auto sides_b = strict_sides_of_plane(a, b);
  if (!sides_b) return Verdict::Unsure;
  if (!sides_a->are_on_both() || !sides_b->are_on_both()) return Verdict::No;
  const auto [s, t] = canonical(a, b, *sides_a, *sides_b);
  const auto first = orientation_3d_filter(s.p, s.q, t.p, t.q);
  const auto second = orientation_3d_filter(s.p, s.r, t.r, t.p);
  if (!first || !second) return Verdict::Unsure;
  return first == Sign::Negative && second == Sign::Negative ? Verdict::Yes : Verdict::No;
}

bool crosses_exactly(const Triangle& triangle_a, const Triangle& triangle_b) {
  check_finite(triangle_a, "triangle A");
  check_finite(triangle_b, "triangle B");
  const Vertices a = corners_of(triangle_a);
  const Vertices b = corners_of(triangle_b);
  const PlaneSides sides_a = sides_of_plane(b, a);
  const PlaneSides sides_b = sides_of_plane(a, b);
  if (sides_a.are_on_both() && sides_b.are_on_both()) {
    const auto [s, t] = canonical(a, b, sides_a, sides_b);
    return orientation_3d(s.p, s.q, t.p, t.q) == Sign::Negative &&
           orientation_3d(s.p, s.r, t.r, t.p) == Sign::Negative;
  }
  // A plane with vertices on both sides is that of a triangle with area. If all of that triangle is
  // then in the other's plane, the other has none.
  if (sides_a.are_on_both() && sides_b.are_all_zero()) return pierces(a, sides_a, b);
  if (sides_b.are_on_both() && sides_a.are_all_zero()) return pierces(b, sides_b, a);
  return false;
}

}  // namespace graze::narrowphase
