#include <graze/narrowphase/convex/core/core.h>
#include <graze/narrowphase/convex/core/point_rows.h>

namespace graze::narrowphase {
namespace {

double signed_like(double value, double sign) {
  return sign < 0 ? -value : value;
}

/// Returns the point of the disc of a radius about the z axis that is farthest along (x, y).
Vec3 rim(double radius, const Vec3& direction, double z) {
  const double size = std::abs(direction.x) + std::abs(direction.y);
  if (!(size > 0)) return {radius, 0, z};
  const double x = direction.x / size;
  const double y = direction.y / size;
  const double scale = radius / std::sqrt(x * x + y * y);
  return {x * scale, y * scale, z};
}

Vec3 cone_support(const Vec3& half, const Vec3& direction) {
  const Vec3 base = rim(half.x, direction, -half.z);
  const Vec3 apex{0, 0, half.z};
  return dot(direction, apex) >= dot(direction, base) ? apex : base;
}

Vec3 ellipsoid_support(const Vec3& semi, const Vec3& direction) {
  const Vec3 scaled{semi.x * direction.x, semi.y * direction.y, semi.z * direction.z};
  const Vec3 unit = unit_or(scaled, {0, 0, 1});
  return {semi.x * unit.x, semi.y * unit.y, semi.z * unit.z};
}

Vec3 farthest(const Vec3* points, std::size_t count, const Vec3& direction) {
  std::size_t best = 0;
  double most = dot(points[0], direction);
  for (std::size_t i = 1; i < count; ++i) {
    const double along = dot(points[i], direction);
    if (along > most) best = i, most = along;
  }
  return points[best];
}

Vec3 own_support(const Core& core, const Vec3& d) {
  const Vec3& half = core.half;
  switch (core.kind) {
    case CoreKind::Segment:
      return {0, 0, signed_like(half.z, d.z)};
    case CoreKind::Box:
      return {signed_like(half.x, d.x), signed_like(half.y, d.y), signed_like(half.z, d.z)};
    case CoreKind::Cylinder:
      return rim(half.x, d, signed_like(half.z, d.z));
    case CoreKind::Cone:
      return cone_support(half, d);
    case CoreKind::Ellipsoid:
      return ellipsoid_support(half, d);
    case CoreKind::Points:
      if (core.rows == nullptr) return farthest(core.points, core.point_count, d);
      return core.points[core.rows->farthest(d, core.point_count)];
    default:
      return {};
  }
}

}  // namespace

Vec3 support(const Core& core, const Vec3& direction) {
  if (core.kind == CoreKind::Point) return core.at;
  if (core.kind == CoreKind::Triangle) return farthest(core.corner, 3, direction);
  return core.at + turned(core, own_support(core, into_own(core, direction)));
}

Vec3 rounded_support(const Core& core, const Vec3& unit_direction) {
  return support(core, unit_direction) + unit_direction * core.radius;
}

double pair_scale(const Core& a, const Core& b) {
  return (a.bounding_radius + b.bounding_radius) + (a.radius + b.radius) +
         2 * (largest(a.at) + largest(b.at));
}

}  // namespace graze::narrowphase
