#include <graze/narrowphase/convex/core/segments.h>
#include <graze/narrowphase/convex/gap/closed_gap.h>

#include <algorithm>

namespace graze::narrowphase {
namespace {

// These are shares of the pair's scale, with u = 2^-53: ends of segments are off by 2 u each. Where
// the lines cross is off by 8 u, 2 u, and 17 u of the one segment's length, at most 2
// (segments.cpp); its point by 5 u; two feet of points on segments by 12 u each, the offset between
// them by 4 u. A point's foot on a box is off by less. In all that is below 76 u.
constexpr double kRelativeSlack = 128 * 0x1p-53;

struct Ends {
  Vec3 from;
  Vec3 to;
};

Ends ends_of(const Core& core) {
  const Vec3 half_segment = core.kind == CoreKind::Segment ? core.axis[2] * core.half.z : Vec3{};
  return {core.at - half_segment, core.at + half_segment};
}

/// Returns half the width of a point or a segment along a direction.
double projected_radius(const Core& core, const Vec3& direction) {
  return core.kind == CoreKind::Segment ? std::abs(dot(core.axis[2], direction)) * core.half.z : 0;
}

/// Returns how far apart the planes across a unit direction are that support two points or
/// segments.
double planes_apart(const Core& a, const Core& b, const Vec3& normal) {
  return dot(b.at - a.at, normal) - (projected_radius(a, normal) + projected_radius(b, normal));
}

/// Returns the direction from a box to a point beside it: out of the faces that the point is
/// beyond, and of no others.
Vec3 out_of_box(const Core& box, const Core& point, const Vec3& otherwise) {
  const Vec3 own = into_own(box, point.at - box.at);
  const auto past = [](double offset, double half) {
    return offset - std::clamp(offset, -half, half);
  };
  const Vec3 offset{past(own.x, box.half.x), past(own.y, box.half.y), past(own.z, box.half.z)};
  return unit_or(turned(box, offset), otherwise);
}

/// Returns the direction at right angles to the segments, which is as well known as these are: that
/// of lines that cross is their product, off by 3.5 u / t where t is the sine of the angle, and by
/// u once it is brought to right angles with one of the two, and so to the other but for t times
/// the rest.
Vec3 across_segments(const Core& a, const Core& b, const Vec3& found) {
  Vec3 best = found;
  double most = planes_apart(a, b, found);
  const auto offer = [&](const Vec3& normal) {
    const double apart = planes_apart(a, b, normal);
    if (apart > most) most = apart, best = normal;
  };
  const auto across = [](const Vec3& v, const Core& core) {
    if (core.kind != CoreKind::Segment) return v;
    const Vec3 axis = unit_or(core.axis[2], {0, 0, 1});
    return unit_or(v - axis * dot(v, axis), v);
  };
  const Vec3 product = a.kind == CoreKind::Segment && b.kind == CoreKind::Segment
                           ? unit_or(cross(a.axis[2], b.axis[2]), found)
                           : found;
  for (const Vec3& normal : {found, product, -product}) {
    const Vec3 across_a = across(normal, a), across_b = across(normal, b);
    offer(across_a);
    offer(across_b);
    offer(across(across_a, b));
    offer(across(across_b, a));
  }
  return best;
}

bool is_line(CoreKind kind) {
  return kind == CoreKind::Point || kind == CoreKind::Segment;
}

NearestPoints nearest_points(const Core& a, const Core& b) {
  if (a.kind == CoreKind::Box) return {nearest_in_box(a, b.at), b.at};
  if (b.kind == CoreKind::Box) return {a.at, nearest_in_box(b, a.at)};
  const Ends of_a = ends_of(a);
  const Ends of_b = ends_of(b);
  if (a.kind == CoreKind::Point) return {a.at, nearest_on_segment(of_b.from, of_b.to, a.at)};
  if (b.kind == CoreKind::Point) return {nearest_on_segment(of_a.from, of_a.to, b.at), b.at};
  return nearest_of_segments(of_a.from, of_a.to, of_b.from, of_b.to);
}

}  // namespace

Vec3 nearest_in_box(const Core& box, const Vec3& point) {
  const Vec3 own = into_own(box, point - box.at);
  const Vec3 inside{std::clamp(own.x, -box.half.x, box.half.x),
                    std::clamp(own.y, -box.half.y, box.half.y),
                    std::clamp(own.z, -box.half.z, box.half.z)};
  if (inside.x == own.x && inside.y == own.y && inside.z == own.z) return point;
  return box.at + turned(box, inside);
}

Vec3 gap_normal(const Core& a, const Core& b, const CoreGap& gap) {
  if (!has_closed_gap(a.kind, b.kind) || !(gap.lower > 0)) return gap.normal;
  if (a.kind == CoreKind::Box) return out_of_box(a, b, gap.normal);
  if (b.kind == CoreKind::Box) return -out_of_box(b, a, -gap.normal);
  if (planes_apart(a, b, gap.normal) >= gap.lower) return gap.normal;
  return across_segments(a, b, gap.normal);
}

bool has_closed_gap(CoreKind a, CoreKind b) {
  return (is_line(a) && is_line(b)) || (a == CoreKind::Point && b == CoreKind::Box) ||
         (a == CoreKind::Box && b == CoreKind::Point);
}

CoreGap nearest(const Core& a, const Core& b, const GapGoal& goal) {
  if (!has_closed_gap(a.kind, b.kind)) return core_gap(a, b, goal);
  const NearestPoints found = nearest_points(a, b);
  CoreGap gap{};
  gap.point_a = found.point_a;
  gap.point_b = found.point_b;
  const Vec3 between = found.point_b - found.point_a;
  gap.slack = kRelativeSlack * pair_scale(a, b);
  gap.upper = length(between);
  gap.lower = std::max(gap.upper - gap.slack, 0.0);
  gap.verdict = gap.lower > 0 ? GapVerdict::Apart : GapVerdict::Touching;
  gap.normal = unit_or(between, unit_or(b.at - a.at, {0, 0, 1}));
  return gap;
}

}  // namespace graze::narrowphase
