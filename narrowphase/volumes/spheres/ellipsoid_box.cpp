// Space scaled by 1 / a_i along each axis turns the ellipsoid into the unit ball and leaves the box
// a box, whose point nearest to the centre is still found axis by axis, with the offset e_i from
// the centre: they touch if sum (e_i / a_i)^2 <= 1. Along an axis with a_i = 0 the offset must be
// 0.

#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/narrowphase/predicates/exact_vector.h>
#include <graze/narrowphase/volumes/ellipsoid_box.h>
#include <graze/narrowphase/volumes/spheres/sphere_distance.h>
#include <graze/narrowphase/volumes/spheres/sphere_stages.h>
#include <cmath>
#include <string>

namespace graze {
namespace narrowphase {
namespace {

// u is the unit roundoff, n the smallest double. A ratio carries two roundings, its square five in
// all, and the sums two more: s is off by at most 7.001 u s. Comparing s - 1 with 12 u (s + 1) +
// 2^-1000 rounds four times more, 2.001 u (s + 1). A ratio that underflows is off by n / 2, and its
// square by no more than n besides: together below 5 n. If s overflows, the bound is infinite or
// NaN.
constexpr double kRatioBound = 12 * 0x1p-53;
constexpr double kRatioUnderflow = 0x1p-1000;

Verdict triage(const double* centre, const double* nearest, const double* semi_axes) {
  double ratio[3];
  for (int i = 0; i < 3; ++i) {
    const double offset = nearest[i] - centre[i];  // rounded, but zero only if the exact one is
    if (offset != 0 && semi_axes[i] == 0) return Verdict::No;
    ratio[i] = offset == 0 ? 0 : offset / semi_axes[i];
  }
  const double s = (ratio[0] * ratio[0] + ratio[1] * ratio[1]) + ratio[2] * ratio[2];
  const double bound = kRatioBound * (s + 1) + kRatioUnderflow;
  if (s - 1 > bound) return Verdict::No;
  if (s - 1 < -bound) return Verdict::Yes;
  return Verdict::Unsure;
}

/// True if sum e_i^2 prod_{j != i} a_j^2 <= prod a_j^2, over the axes with a_i > 0: the triage has
/// seen that the others have e_i = 0.
bool is_touching_exactly(const double* centre, const double* nearest, const double* semi_axes) {
  CommonUnit unit({semi_axes[0], semi_axes[1], semi_axes[2]});
  unit.include(centre, 3);
  unit.include(nearest, 3);
  BigInteger left;
  BigInteger product = BigInteger::from_double(1, 0);
  for (int i = 0; i < 3; ++i) {
    if (semi_axes[i] == 0) continue;
    const BigInteger axis2 = squared(unit.of(semi_axes[i]));
    left = left * axis2 + squared(unit(nearest[i], centre[i])) * product;
    product = product * axis2;
  }
  return (left - product).sign() != Sign::Positive;
}

}  // namespace

Decision decide(const Ellipsoid& ellipsoid, const Aabb& box) {
  const double* centre = ellipsoid.centre.data();
  const double* semi_axes = ellipsoid.semi_axes.data();
  const auto nearest = nearest_point(box, centre);
  const Verdict verdict = triage(centre, nearest.data(), semi_axes);
  if (verdict != Verdict::Unsure) return {verdict == Verdict::Yes, Stage::Triage};
  return {is_touching_exactly(centre, nearest.data(), semi_axes), Stage::Exact};
}

}  // namespace narrowphase

void check_ellipsoid(const Ellipsoid& ellipsoid, const char* what) {
  bvh::in_standard_arithmetic([&] {
    for (int i = 0; i < 3; ++i) {
      if (!std::isfinite(ellipsoid.centre.data()[i])) {
        throw InputError(std::string(what) + ": coordinate " + "xyz"[i] +
                         " of the centre is not finite");
      }
      const double semi_axis = ellipsoid.semi_axes.data()[i];
      if (!(semi_axis >= 0) || !std::isfinite(semi_axis)) {
        throw InputError(std::string(what) + ": semi-axis " + "xyz"[i] +
                         " is negative or not finite");
      }
    }
  });
}

bool intersects(const Ellipsoid& ellipsoid, const Aabb& box) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    check_ellipsoid(ellipsoid, "ellipsoid");
    bvh::check_box(box, "box");
    return narrowphase::decide(ellipsoid, box).is_hit;
  });
}

bool intersects(const Aabb& box, const Ellipsoid& ellipsoid) {
  return intersects(ellipsoid, box);
}

}  // namespace graze
