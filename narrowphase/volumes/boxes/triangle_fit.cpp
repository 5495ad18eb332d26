#include <graze/bvh/fit/aabb_fit.h>
#include <graze/bvh/fit/kdop_fit.h>
#include <graze/bvh/fit/methods/moments.h>
#include <graze/bvh/fit/obb_fit.h>
#include <graze/bvh/fit/sphere_fit.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/element_error.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/triangle_fit.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace graze {
namespace {

using Corners = std::vector<Eigen::Vector3d>;

/// Returns three corners for each triangle. Names the triangle of a coordinate that is not finite.
Corners corners_of(std::span<const Triangle> triangles) {
  Corners corners;
  corners.reserve(3 * triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& triangle = triangles[i];
    if (!triangle.a.allFinite() || !triangle.b.allFinite() || !triangle.c.allFinite()) {
      bvh::at_element("triangle", i, [&] {
        narrowphase::check_finite(triangle, ("triangle " + std::to_string(i)).c_str());
      });
    }
    corners.insert(corners.end(), {triangle.a, triangle.b, triangle.c});
  }
  return corners;
}

/// Returns the covariance of the surface in local units, or of the corners if there is no area.
/// With the mean taken off first, a triangle of area A, middle m and corners p, q, r adds A / 12 (9
/// m m^T + p p^T + q q^T + r r^T).
Eigen::Matrix3d surface_covariance(const bvh::LocalPoints& corners) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double total = 0;
  const auto area_of = [&](std::size_t i) {
    const Eigen::Vector3d p = corners.point(i);
    return 0.5 * (corners.point(i + 1) - p).cross(corners.point(i + 2) - p).norm();
  };
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const double area = area_of(i);
    mean += area / 3 * (corners.point(i) + corners.point(i + 1) + corners.point(i + 2));
    total += area;
  }
  if (!(total > 0)) return bvh::covariance(corners);
  mean /= total;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const double weight = area_of(i) / total;
    const Eigen::Vector3d p = corners.point(i) - mean;
    const Eigen::Vector3d q = corners.point(i + 1) - mean;
    const Eigen::Vector3d r = corners.point(i + 2) - mean;
    const Eigen::Vector3d thrice_middle = p + q + r;  // 9 m m^T is its square
    sum += weight / 12 *
           (thrice_middle * thrice_middle.transpose() + p * p.transpose() + q * q.transpose() +
            r * r.transpose());
  }
  return sum;
}

}  // namespace

Aabb bounding_aabb(std::span<const Triangle> triangles) {
  return bvh::in_standard_arithmetic(
      [&]() -> Aabb { return bounding_aabb(corners_of(triangles)); });
}

Sphere ritter_sphere(std::span<const Triangle> triangles) {
  return bvh::in_standard_arithmetic(
      [&]() -> Sphere { return ritter_sphere(corners_of(triangles)); });
}

Sphere bounding_sphere(std::span<const Triangle> triangles) {
  return bvh::in_standard_arithmetic(
      [&]() -> Sphere { return bounding_sphere(corners_of(triangles)); });
}

KDop<18> bounding_kdop(std::span<const Triangle> triangles) {
  return bvh::in_standard_arithmetic(
      [&]() -> KDop<18> { return bounding_kdop(corners_of(triangles)); });
}

Obb ditetrahedron_box(std::span<const Triangle> triangles) {
  return bvh::in_standard_arithmetic(
      [&]() -> Obb { return ditetrahedron_box(corners_of(triangles)); });
}

Obb bounding_obb(std::span<const Triangle> triangles) {
  return bvh::in_standard_arithmetic([&]() -> Obb { return bounding_obb(corners_of(triangles)); });
}

Obb covariance_box(std::span<const Triangle> triangles) {
  return bvh::in_standard_arithmetic([&]() -> Obb {
    const Corners corners = corners_of(triangles);
    const bvh::LocalPoints local(corners);
    return box_along(bvh::principal_axes(surface_covariance(local)), local, corners);
  });
}

}  // namespace graze
