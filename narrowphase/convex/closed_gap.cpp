#include <graze/narrowphase/convex/closed_gap.h>
#include <graze/narrowphase/convex/segments.h>

#include <algorithm>

namespace graze::narrowphase {
namespace {

// Of the pair's scale, u = 2^-53: ends of segments are off by 2 u each. Where the lines cross is
// off by 8 u, 2 u, and 17 u of the one segment's length, at most 2 (segments.cpp); its point by 5
// u; two feet of points on segments by 12 u each, the way between them by 4 u. A point's foot on a
// box is off by less. Below 76 u in all.
constexpr double kRelativeSlack = 128 * 0x1p-53;

struct Ends {
  Vec3 from;
  Vec3 to;
};

Ends ends_of(const Core& core) {
  const Vec3 reach = core.kind == CoreKind::Segment ? core.axis[2] * core.half.z : Vec3{};
  return {core.at - reach, core.at + reach};
}

/// The point of the box nearest to a point. A centre inside stays where it is.
Vec3 nearest_in_box(const Core& box, const Vec3& point) {
  const Vec3 own = into_own(box, point - box.at);
  const Vec3 inside{std::clamp(own.x, -box.half.x, box.half.x),
                    std::clamp(own.y, -box.half.y, box.half.y),
                    std::clamp(own.z, -box.half.z, box.half.z)};
  if (inside.x == own.x && inside.y == own.y && inside.z == own.z) return point;
  return box.at + turned(box, inside);
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
