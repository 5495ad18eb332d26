#include <graze/narrowphase/convex/closed_gap.h>
#include <graze/narrowphase/convex/core_ray.h>
#include <graze/narrowphase/convex/meeting_points.h>

#include <algorithm>
#include <optional>

namespace graze::narrowphase {
namespace {

Core shifted(Core core, const Vec3& by) {
  core.at = core.at + by;
  for (Vec3& corner : core.corner)
    corner = corner + by;
  return core;
}

/// The outermost point of a set on the line through a point along a unit direction; nothing if the
/// line misses the set, or the set is a triangle.
std::optional<Vec3> end_on_line(const Core& core, const Vec3& point, const Vec3& out) {
  if (core.kind == CoreKind::Triangle) return std::nullopt;
  const Vec3 start = point + out * (dot(core.at - point, out) + 2 * (core.reach + core.radius));
  const std::optional<CoreRayHit> hit = cast_ray(core, start, -out);
  if (!hit) return std::nullopt;
  return start - out * hit->distance;
}

double radius_of(const Core& core) {
  return core.kind == CoreKind::Segment ? core.radius : core.half.x;
}

}  // namespace

double smaller_size(const Core& a, const Core& b) {
  return std::min(a.reach + a.radius, b.reach + b.radius);
}

bool lie_along(const Penetration& way, double tolerance) {
  return length(cross(way.point_a - way.point_b, way.normal)) <= tolerance;
}

// Moved out by the depth and a clearance, the two are nowhere nearer than the clearance, and
// somewhere no further apart than that and what the depth is more than the least. So are their
// nearest points, along the normal, and across as a leg of that triangle: 2^-17 of the smaller size
// at most, of the wider clearance.
//
// A core's point that is nearest to another core is as far from a plane that supports the first as
// the gap's bounds are from each other, if that plane is the one of the lower bound. Moved out
// along its normal it stays so, whatever the radius; the way between the points would turn it.
//
// That near, a search about round sets may end open, and a wider clearance help. Else the points
// are moved along the normal, to where the line through one of them leaves each set: unless that
// is far from where they are, as where the line lies in a face.
MeetingPoints meeting_points(const Core& a, const Core& b, const Penetration& way) {
  const double size = smaller_size(a, b);
  MeetingPoints met;
  for (const double clearance : {kClearance * size, 16 * kClearance * size}) {
    const Vec3 out = way.normal * (way.depth + clearance);
    const CoreGap gap = nearest(a, shifted(b, out));
    const Vec3& normal = gap.lower > 0 ? gap.normal : way.normal;
    met = {gap.point_a + normal * a.radius, gap.point_b - normal * b.radius - out};
    if (gap.verdict == GapVerdict::Apart) return met;
  }
  const Vec3 on_line = met.on_b;
  const auto settle = [&](const Core& core, const Vec3& normal, Vec3& point) {
    const std::optional<Vec3> end = end_on_line(core, on_line, normal);
    if (end && length(*end - point) < 64 * kClearance * size) point = *end;
  };
  settle(a, way.normal, met.on_a);
  settle(b, -way.normal, met.on_b);
  return met;
}

bool settle_between(const FaceOf& incident, const FaceOf& reference, double sign, double touching,
                    ContactPoint& touch) {
  const Vec3 line = reference.face.corner[1] - reference.face.corner[0];
  const Vec3 across = unit_or(cross(touch.normal, line), touch.normal);
  const double off = dot(across, touch.point_a - reference.face.corner[0]);
  if (!(std::abs(off) > touching)) return true;
  const double radius = radius_of(incident.core);
  const double share = radius / (radius + radius_of(reference.core));
  const Vec3 point = touch.point_a - across * (off * share);
  const std::optional<Vec3> met = end_on_line(reference.core, point, touch.normal * sign);
  const std::optional<Vec3> own = end_on_line(incident.core, point, -(touch.normal * sign));
  if (!met || !own) return false;
  touch.point_a = sign > 0 ? *met : *own;
  touch.point_b = sign > 0 ? *own : *met;
  touch.depth = dot(touch.point_a - touch.point_b, touch.normal);
  return true;
}

}  // namespace graze::narrowphase
