#include <graze/bvh/fit/measure.h>
#include <graze/bvh/fit/methods/kdop_faces.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace graze {
namespace {

double box_volume(const Eigen::Vector3d& size) {
  return size.x() * size.y() * size.z();
}

double box_surface(const Eigen::Vector3d& size) {
  return 2 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
}

}  // namespace

double volume(const Aabb& box) {
  return bvh::in_standard_arithmetic([&]() -> double { return box_volume(box.max - box.min); });
}

double volume(const Obb& box) {
  return bvh::in_standard_arithmetic([&]() -> double { return box_volume(2 * box.half_extents); });
}

double volume(const Sphere& sphere) {
  return bvh::in_standard_arithmetic([&]() -> double {
    return 4 * std::numbers::pi / 3 * sphere.radius * sphere.radius * sphere.radius;
  });
}

double surface(const Aabb& box) {
  return bvh::in_standard_arithmetic([&]() -> double { return box_surface(box.max - box.min); });
}

double surface(const Obb& box) {
  return bvh::in_standard_arithmetic([&]() -> double { return box_surface(2 * box.half_extents); });
}

double surface(const Sphere& sphere) {
  return bvh::in_standard_arithmetic(
      [&]() -> double { return 4 * std::numbers::pi * sphere.radius * sphere.radius; });
}

// This is the divergence theorem for the field x / 3: a face of area a at distance d from the
// origin, along its outer normal, adds a d / 3.
double volume(const KDop<18>& kdop) {
  return bvh::in_standard_arithmetic([&]() -> double {
    const bvh::KDopFaces faces = bvh::faces_of(kdop);
    double sum = 0;
    for (const bvh::KDopFace& face : faces.faces)
      sum += face.area * face.distance;
    return std::max(sum / 3, 0.0) * faces.unit * faces.unit * faces.unit;
  });
}

double surface(const KDop<18>& kdop) {
  return bvh::in_standard_arithmetic([&]() -> double {
    const bvh::KDopFaces faces = bvh::faces_of(kdop);
    double sum = 0;
    for (const bvh::KDopFace& face : faces.faces)
      sum += face.area;
    return sum * faces.unit * faces.unit;
  });
}

}  // namespace graze
