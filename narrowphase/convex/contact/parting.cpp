#include <graze/narrowphase/convex/contact/contact_points.h>
#include <graze/narrowphase/convex/contact/meeting_points.h>
#include <graze/narrowphase/convex/core/contact_face.h>
#include <graze/narrowphase/convex/gap/closed_gap.h>

#include <algorithm>
#include <initializer_list>

namespace graze::narrowphase {
namespace {

// Gaps and the points that witness them are known to this share of the scale. The error of a normal
// is that of the points divided by the gap, so that the normals of gaps below kWellKnown are
// measured by the supports.
constexpr double kRoundingOfGaps = 0x1p-40;
constexpr double kWellKnown = 0x1p-10;

// A face next to a normal is one that leans by 8 degrees at most.
constexpr double kNextFace = 0.99;

// Witnesses of two boxes are this near to the segment between them, as a share of the scale.
constexpr double kTouchingBoxes = 0x1p-34;

/// Replaces the normal by that of a face next to it, if that costs no depth beyond what is allowed:
/// the polytope comes only near a face's normal.
void prefer_face_normal(const Core& a, const Core& b, Penetration& penetration) {
  const double allowance = depth_tolerance(a, b);
  const Vec3 found = penetration.normal;
  double limit = penetration.is_open ? penetration.depth : penetration.lower + allowance;
  for (const Vec3& normal : {face_along(a, found).normal, -face_along(b, -found).normal}) {
    if (dot(normal, found) < kNextFace) continue;
    Penetration offered = along(a, b, normal);
    if (offered.depth > limit || offered.depth < 0) continue;
    offered.source = penetration.source;
    offered.is_open = penetration.is_open;
    offered.lower = penetration.lower;
    penetration = offered;
    limit = offered.depth - allowance;  // the second face must be better than the first
  }
}

/// Parts the two along the line between the nearest points of cores that are apart, or nearly so.
/// False if the depth along it is not the least, to depth_tolerance().
bool part_along_gap(const Core& a, const Core& b, const CoreGap& gap, Parting& parting) {
  const double radii = a.radius + b.radius;
  const double scale = pair_scale(a, b);
  if (!(gap.upper > kRoundingOfGaps * scale || (radii == 0 && gap.upper > 0))) return false;
  const Vec3 between = unit_or(gap.point_b - gap.point_a, gap.normal);
  Penetration& penetration = parting.penetration;
  penetration.normal = gap.lower > 0 ? gap_normal(a, b, gap) : between;
  penetration.depth = radii - gap.upper;  // which is no more than the least
  // Planes at right angles to the normal are as far apart as the bound says, which is then enough.
  if (gap.upper - gap.lower <= kRoundingOfGaps * scale && gap.upper > kWellKnown * scale)
    return true;
  const double along_normal = along(a, b, penetration.normal).depth;
  if (along_normal - penetration.depth > depth_tolerance(a, b)) return false;
  if (along_normal - penetration.depth > kRoundingOfGaps * scale) penetration.depth = along_normal;
  return true;
}

/// True if the depth is proved to be the least, to depth_tolerance(). Cores that are apart are no
/// further apart than their gap says: so the depth is no less than the radii less that, whatever
/// searches for cores that overlap could prove. Where the depth is too large the gap's directions
/// are tried.
bool is_least(const Core& a, const Core& b, const CoreGap& gap, Penetration& penetration) {
  const double tolerance = depth_tolerance(a, b);
  const double least = a.radius + b.radius - gap.upper;
  const auto is_thin = [](const Core& core) {
    return core.kind == CoreKind::Point || core.kind == CoreKind::Segment;
  };
  // For points and segments the bound is the radii, which is one only if they meet.
  const bool is_bounded = !penetration.is_open && !(is_thin(a) && is_thin(b));
  penetration.lower = is_bounded ? std::max(penetration.lower, least) : least;
  if (gap.upper > 0 && penetration.depth - penetration.lower > tolerance) {
    const Vec3 between = unit_or(gap.point_b - gap.point_a, gap.normal);
    for (const Vec3& normal : {between, gap.normal, gap_normal(a, b, gap)}) {
      Penetration offered = along(a, b, unit_or(normal, between));
      offered.source = penetration.source;
      offered.lower = penetration.lower;
      if (offered.depth < penetration.depth) penetration = offered;
    }
  }
  penetration.is_open = !(penetration.depth - penetration.lower <= tolerance);
  return !penetration.is_open;
}

}  // namespace

Parting part_boxes(const BoxAxes& boxes) {
  Parting parting;
  parting.penetration = boxes.least_penetration();
  parting.penetration.depth = std::max(parting.penetration.depth, 0.0);
  parting.has_witnesses = parting.penetration.has_witnesses &&
                          lie_along(parting.penetration, kTouchingBoxes * boxes.scale());
  return parting;
}

Parting part(const Core& a, const Core& b, const CoreGap& gap) {
  Parting parting;
  Penetration& penetration = parting.penetration;
  if (part_along_gap(a, b, gap, parting)) {
    penetration.depth = std::max(penetration.depth, 0.0);
    penetration.point_a = gap.point_a + penetration.normal * a.radius;
    penetration.point_b = gap.point_b - penetration.normal * b.radius;
    parting.has_witnesses = gap.verdict == GapVerdict::Apart;
    return parting;
  }
  if (a.kind == CoreKind::Box && b.kind == CoreKind::Box) {
    return part_boxes(BoxAxes(a, b));
  } else if (a.kind == CoreKind::Box && b.kind == CoreKind::Point) {
    penetration = nearest_face(a, b);
  } else if (a.kind == CoreKind::Point && b.kind == CoreKind::Box) {
    const Penetration found = nearest_face(b, a);
    penetration = {-found.normal, found.depth, found.point_b, found.point_a, found.source, false};
  } else {
    penetration = narrowphase::penetration(a, b);
    parting.is_asked = true;
    parting.is_failed = !is_least(a, b, gap, penetration);
    prefer_face_normal(a, b, penetration);
    parting.has_witnesses = penetration.has_witnesses;
  }
  penetration.depth = std::max(penetration.depth, 0.0);
  return parting;
}

}  // namespace graze::narrowphase
