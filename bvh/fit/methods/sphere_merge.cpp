#include <graze/bvh/error.h>
#include <graze/bvh/fit/sphere_fit.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/local_frame.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {
namespace {

/// Units in which centres' differences and radii are below 2, and the largest is about 1: none
/// overflows, and no square of the largest underflows.
class MergeUnit {
 public:
  MergeUnit(const Sphere& sphere_a, const Sphere& sphere_b) {
    if (!(sphere_b.centre - sphere_a.centre).allFinite()) half_ = 0.5;
    double largest = half_ * std::max(sphere_a.radius, sphere_b.radius);
    for (int k = 0; k < 3; ++k)
      largest = std::max(largest, std::abs(difference(sphere_a.centre, sphere_b.centre, k)));
    exponent_ = largest == 0 ? 0 : std::max(std::ilogb(largest), bvh::LocalFrame::kMinExponent);
    scale_ = std::ldexp(1.0, -exponent_);
  }

  double to_local(double radius) const { return half_ * radius * scale_; }

  /// Returns the distance, rounded up. With u = 2^-53 the differences lose u, squares, sums and
  /// root 3.5 u, the product u, of the 8 u that are added. Squares may underflow if all differences
  /// are below 2^-500.
  double distance_above(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    if (a == b) return 0;
    double square = 0;
    for (int k = 0; k < 3; ++k) {
      const double d = difference(a, b, k) * scale_;
      square += d * d;
    }
    return square < 0x1p-1000 ? 0x1p-499 : std::sqrt(square) * (1 + 0x1p-50);
  }

  /// Returns the radius in the units of the spheres, rounded up.
  double to_world_above(double local) const {
    double radius = std::ldexp(local, exponent_) / half_;
    if (std::ldexp(half_ * radius, -exponent_) < local) {
      radius = std::nextafter(radius, std::numeric_limits<double>::infinity());
    }
    return radius;
  }

 private:
  double difference(const Eigen::Vector3d& a, const Eigen::Vector3d& b, int k) const {
    return half_ * b.data()[k] - half_ * a.data()[k];
  }

  double half_ = 1;  ///< 0.5 if a difference of coordinates overflows
  int exponent_;
  double scale_;
};

}  // namespace

Sphere merged(const Sphere& sphere_a, const Sphere& sphere_b) {
  return bvh::in_standard_arithmetic([&]() -> Sphere {
    check_sphere(sphere_a, "first sphere");
    check_sphere(sphere_b, "second sphere");
    const bool is_a_larger = sphere_a.radius >= sphere_b.radius;
    const Sphere& large = is_a_larger ? sphere_a : sphere_b;
    const Sphere& small = is_a_larger ? sphere_b : sphere_a;
    const MergeUnit unit(large, small);
    const double distance = unit.distance_above(large.centre, small.centre);
    const double large_radius = unit.to_local(large.radius);
    const double small_radius = unit.to_local(small.radius);
    // The factor exceeds what both sides round.
    if (distance * (1 + 0x1p-50) <= large_radius - small_radius) return large;

    // The new sphere's diameter spans both along the line of centres.
    const double share =
        std::clamp((distance + small_radius - large_radius) / (2 * distance), 0.0, 1.0);
    Sphere sphere;
    for (int k = 0; k < 3; ++k)
      sphere.centre.data()[k] = std::lerp(large.centre.data()[k], small.centre.data()[k], share);
    const double to_large = unit.distance_above(sphere.centre, large.centre) + large_radius;
    const double to_small = unit.distance_above(sphere.centre, small.centre) + small_radius;
    sphere.radius = unit.to_world_above(std::max(to_large, to_small) * (1 + 0x1p-51));
    if (!std::isfinite(sphere.radius)) {
      throw InputError("spheres too far apart: the sphere around them overflows");
    }
    return sphere;
  });
}

}  // namespace graze
