#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/box_frame.h>
#include <graze/narrowphase/volumes/contains.h>
#include <cmath>
#include <string>
#include <utility>

namespace graze {
namespace {

void check_point(const Eigen::Vector3d& point, const char* what) {
  for (int i = 0; i < 3; ++i) {
    if (std::isfinite(point.data()[i])) continue;
    throw InputError(std::string(what) + ": coordinate " + "xyz"[i] + " is not finite");
  }
}

/// Returns the sign of (a + b) - bound, exactly, for finite doubles. Where the rounded sum,
/// infinite or not, differs from the bound, it is on the right side of it, for rounding keeps order
/// and the bound is a double. Otherwise what the sum lacks decides: with |a| >= |b| both
/// differences below are exact (Dekker 1971) and representable, so that nothing overflows.
int compare_sum(double a, double b, double bound) {
  const double sum = a + b;
  if (sum != bound) return sum < bound ? -1 : 1;
  if (std::abs(a) < std::abs(b)) std::swap(a, b);
  const double lack = b - (sum - a);
  return (lack > 0) - (lack < 0);
}

/// True if the point is in the slab. Each direction has one or two components that are not zero,
/// each 1 or -1, the first of them 1. One coordinate alone is its sum with 0.
bool is_in_slab(const KDop<18>& kdop, int slab, const double* point) {
  double terms[2] = {0, 0};
  int count = 0;
  for (int i = 0; i < 3; ++i) {
    const int factor = kKDopDirections<18>[slab][i];
    if (factor != 0) terms[count++] = factor * point[i];
  }
  return compare_sum(terms[0], terms[1], kdop.min[slab]) >= 0 &&
         compare_sum(terms[0], terms[1], kdop.max[slab]) <= 0;
}

}  // namespace

bool contains(const Aabb& box, const Eigen::Vector3d& point) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    bvh::check_box(box, "box");
    check_point(point, "point");
    bool is_inside = true;
    for (int i = 0; i < 3; ++i) {
      is_inside &= box.min.data()[i] <= point.data()[i] && point.data()[i] <= box.max.data()[i];
    }
    return is_inside;
  });
}

bool contains(const Aabb& outer, const Aabb& inner) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    bvh::check_box(outer, "outer box");
    bvh::check_box(inner, "inner box");
    bool is_inside = true;
    for (int i = 0; i < 3; ++i) {
      is_inside &= outer.min.data()[i] <= inner.min.data()[i];
      is_inside &= inner.max.data()[i] <= outer.max.data()[i];
    }
    return is_inside;
  });
}

bool contains(const Obb& box, const Eigen::Vector3d& point) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    bvh::check_box(box, "box");
    check_point(point, "point");
    const Eigen::Vector3d local = narrowphase::point_into_frame(point, box.pose);
    check_point(local, "point in the frame of the box");
    bool is_inside = true;
    for (int i = 0; i < 3; ++i)
      is_inside &= std::abs(local.data()[i]) <= box.half_extents.data()[i];
    return is_inside;
  });
}

bool contains(const KDop<18>& kdop, const Eigen::Vector3d& point) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    bvh::check_kdop(kdop, "k-DOP");
    check_point(point, "point");
    bool is_inside = true;
    for (int slab = 0; slab < KDop<18>::kSlabs; ++slab)
      is_inside &= is_in_slab(kdop, slab, point.data());
    return is_inside;
  });
}

}  // namespace graze
