#include <graze/narrowphase/convex/depth/aligned_parting.h>
#include <graze/narrowphase/convex/depth/expanding_polytope.h>
#include <graze/narrowphase/convex/depth/penetration.h>

#include <initializer_list>
#include <optional>

namespace graze::narrowphase {
namespace {

/// Of fixed directions, that of the least width: the line between the middles and the axes of both.
Penetration best_of_fixed(const Core& a, const Core& b) {
  const Vec3 between = unit_or(b.at - a.at, {0, 0, 1});
  Penetration best = along(a, b, between);
  const auto offer = [&](const Vec3& direction) {
    const Penetration found = along(a, b, unit_or(direction, between));
    if (found.depth < best.depth) best = found;
  };
  for (const Core* core : {&a, &b}) {
    for (const Vec3& axis : core->axis) {
      offer(axis);
      offer(-axis);
    }
  }
  best.source = PenetrationSource::Fixed;
  return best;
}

bool is_thin(const Core& core) {
  return core.kind == CoreKind::Point || core.kind == CoreKind::Segment;
}

/// The difference of two points or segments is flat: at right angles to it only the radii overlap,
/// and less than those do nowhere. No polytope could close around it.
Penetration out_of_plane(const Core& a, const Core& b) {
  Penetration best = best_of_fixed(a, b);
  const Vec3 across = unit_or(cross(a.axis[2], b.axis[2]), best.normal);
  for (const Vec3& normal : {across, -across}) {
    Penetration found = along(a, b, normal);
    found.source = PenetrationSource::Fixed;
    if (found.depth < best.depth) best = found;
  }
  return best;
}

}  // namespace

Penetration along(const Core& a, const Core& b, const Vec3& unit_direction) {
  Penetration result{};
  result.normal = unit_direction;
  result.point_a = rounded_support(a, unit_direction);
  result.point_b = rounded_support(b, -unit_direction);
  result.depth = dot(result.point_a - result.point_b, unit_direction);
  return result;
}

double depth_tolerance(const Core& a, const Core& b) {
  const double size_a = a.bounding_radius + a.radius;
  const double size_b = b.bounding_radius + b.radius;
  return kDepthTolerance * (size_a < size_b ? size_a : size_b) + kDepthRounding * pair_scale(a, b);
}

Penetration penetration(const Core& a, const Core& b) {
  const double tolerance = depth_tolerance(a, b);
  if (is_thin(a) && is_thin(b)) {
    Penetration result = out_of_plane(a, b);
    result.lower = a.radius + b.radius;
    result.is_open = !(result.depth - (a.radius + b.radius) <= tolerance);
    return result;
  }
  if (const std::optional<Penetration> known = part_aligned(a, b, tolerance)) return *known;
  const PolytopeDepth found = polytope_depth(a, b, tolerance);
  // A polytope of sets of which one is lost in the rounding of the other may close without a
  // normal.
  if (found.is_closed && largest(found.normal) > 0) {
    Penetration result = along(a, b, found.normal);
    result.source = PenetrationSource::Polytope;
    result.lower = found.lower;
    return result;
  }
  Penetration result = best_of_fixed(a, b);
  const auto offer = [&](const Vec3& normal, PenetrationSource source) {
    Penetration offered = along(a, b, normal);
    offered.source = source;
    if (!(offered.depth < result.depth)) return;
    result = offered;
  };
  if (largest(found.normal) > 0) offer(found.normal, PenetrationSource::Polytope);
  if (const std::optional<Vec3> direction = ask_ccd(a, b)) {
    offer(*direction, PenetrationSource::Ccd);
  }
  result.lower = found.lower;
  // The polytope may be torn and its best plane still be good enough.
  result.is_open = !(result.depth - found.lower <= tolerance);
  return result;
}

}  // namespace graze::narrowphase
