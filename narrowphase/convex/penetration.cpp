#include <graze/narrowphase/convex/ccd.h>
#include <graze/narrowphase/convex/penetration.h>

#include <optional>

namespace graze::narrowphase {
namespace {

/// Of fixed directions, that of the least width: the way between the middles and the axes of both.
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
  best.source = PenetrationSource::Fallback;
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

Penetration penetration(const Core& a, const Core& b) {
  Penetration result;
  if (const std::optional<Vec3> epa = ask_ccd(a, b, CcdMethod::ExpandingPolytope)) {
    result = along(a, b, *epa);
    result.source = PenetrationSource::ExpandingPolytope;
  } else if (const std::optional<Vec3> mpr = ask_ccd(a, b, CcdMethod::PortalRefinement)) {
    result = along(a, b, *mpr);
    result.source = PenetrationSource::PortalRefinement;
  } else {
    return best_of_fixed(a, b);
  }
  return result;
}

}  // namespace graze::narrowphase
