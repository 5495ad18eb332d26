#include <graze/narrowphase/convex/depth/penetration.h>

#include <ccd/ccd.h>
#include <cmath>
#include <csetjmp>

namespace graze::narrowphase {
namespace {

/// Holds what both callbacks share.
struct Attempt {
  double to_units;
  std::jmp_buf end;
  int budget = kCcdBudget;
};

struct Side {
  const Core* core;
  Attempt* attempt;
};

Vec3 from_ccd(const ccd_vec3_t& v) {
  return {v.v[0], v.v[1], v.v[2]};
}

void to_ccd(const Vec3& v, ccd_vec3_t* out) {
  out->v[0] = v.x;
  out->v[1] = v.y;
  out->v[2] = v.z;
}

void support_of(const void* side, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Side& s = *static_cast<const Side*>(side);
  const Vec3 unit = unit_or(from_ccd(*direction), {0, 0, 1});
  const Vec3 found = rounded_support(*s.core, unit) * s.attempt->to_units;
  // Once the budget is spent, or a point is not finite, this leaves libccd for good: MPR holds no
  // memory, and no frame between here and there has anything to destroy, so the jump is safe.
  if (--s.attempt->budget < 0 || !std::isfinite(dot(found, found))) {
    std::longjmp(s.attempt->end, 1);
  }
  to_ccd(found, point);
}

void centre_of(const void* side, ccd_vec3_t* point) {
  const Side& s = *static_cast<const Side*>(side);
  Vec3 centre = s.core->at;
  if (s.core->kind == CoreKind::Triangle) {
    centre = (s.core->corner[0] + s.core->corner[1] + s.core->corner[2]) * (1.0 / 3);
  }
  to_ccd(centre * s.attempt->to_units, point);
}

}  // namespace

std::optional<Vec3> ask_ccd(const Core& a, const Core& b) {
  const double size_a = a.bounding_radius + a.radius;
  const double size_b = b.bounding_radius + b.radius;
  int exponent = 0;
  std::frexp(size_a < size_b ? size_a : size_b, &exponent);
  Attempt attempt;
  attempt.to_units = std::ldexp(1.0, -exponent);
  const Side side_a{&a, &attempt};
  const Side side_b{&b, &attempt};

  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = support_of;
  ccd.support2 = support_of;
  ccd.center1 = centre_of;
  ccd.center2 = centre_of;
  ccd.max_iterations = 100;
  ccd.mpr_tolerance = 1e-6;

  double depth = 0;
  ccd_vec3_t direction{};
  ccd_vec3_t position{};
  if (setjmp(attempt.end) != 0) return std::nullopt;
  if (ccdMPRPenetration(&side_a, &side_b, &ccd, &depth, &direction, &position) != 0) {
    return std::nullopt;
  }
  const Vec3 found = from_ccd(direction);
  const double size = length(found);
  if (!(size > 0.5) || !(size < 2)) return std::nullopt;
  return unit_or(found, {});
}

}  // namespace graze::narrowphase
