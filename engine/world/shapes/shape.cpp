#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/placed_shape.h>
#include <graze/engine/world/shape.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace graze {
namespace {

[[noreturn]] void refuse(const char* shape, const std::string& what) {
  throw InputError(std::string(shape) + ": " + what);
}

void check_length(double length, const char* shape, const std::string& member) {
  if (!std::isfinite(length)) refuse(shape, member + " is not finite");
  if (!(length > 0)) refuse(shape, member + " is not positive");
  if (length < kSmallestLength) refuse(shape, member + " is below the smallest length");
  if (length > kLargestLength) refuse(shape, member + " is beyond the largest length");
}

void check_coordinates(const Eigen::Vector3d& point, const char* shape, const char* member) {
  for (int i = 0; i < 3; ++i) {
    if (std::abs(point.data()[i]) <= kLargestLength) continue;
    refuse(shape, std::string("coordinate ") + "xyz"[i] + " of the " + member +
                      " is not finite or beyond the largest length");
  }
}

Capsule checked(const Capsule& capsule) {
  return bvh::in_standard_arithmetic([&]() -> Capsule {
    check_length(capsule.radius, "capsule", "the radius");
    if (capsule.half_length != 0) check_length(capsule.half_length, "capsule", "the half length");
    return capsule;
  });
}

template <typename Round>
Round checked(const Round& round, const char* shape) {
  return bvh::in_standard_arithmetic([&]() -> Round {
    check_length(round.radius, shape, "the radius");
    check_length(round.half_height, shape, "the half height");
    return round;
  });
}

Sphere checked(const Sphere& sphere) {
  return bvh::in_standard_arithmetic([&]() -> Sphere {
    check_coordinates(sphere.centre, "sphere", "centre");
    check_length(sphere.radius, "sphere", "the radius");
    return sphere;
  });
}

Box checked(const Box& box) {
  return bvh::in_standard_arithmetic([&]() -> Box {
    for (int i = 0; i < 3; ++i)
      check_length(box.half_extents.data()[i], "box", std::string("half extent ") + "xyz"[i]);
    return box;
  });
}

Ellipsoid checked(const Ellipsoid& ellipsoid) {
  return bvh::in_standard_arithmetic([&]() -> Ellipsoid {
    check_coordinates(ellipsoid.centre, "ellipsoid", "centre");
    for (int i = 0; i < 3; ++i)
      check_length(ellipsoid.semi_axes.data()[i], "ellipsoid",
                   std::string("semi-axis ") + "xyz"[i]);
    return ellipsoid;
  });
}

/// Scaling leaves a normal whose squared length is within 8 u of 1, u = 2^-53: x, y and z carry u
/// each, the root 2 u, the quotients u more, so that the length is within 3 u, its square within 6
/// u, and the sum here within 2 u of that. A normal as near to that length stays as it is: else a
/// shape made from another's numbers would differ from it.
constexpr double kUnitSquareError = 0x1p-50;

bool is_unit(const double* n) {
  return std::abs(((n[0] * n[0] + n[1] * n[1]) + n[2] * n[2]) - 1) <= kUnitSquareError;
}

/// Returns the same half-space or plane with a normal of length 1 up to rounding.
template <typename Flat>
Flat checked_flat(const Flat& flat, const char* what) {
  return bvh::in_standard_arithmetic([&]() -> Flat {
    check_coordinates(flat.normal, what, "normal");
    const double* n = flat.normal.data();
    const double largest = std::max(std::abs(n[0]), std::max(std::abs(n[1]), std::abs(n[2])));
    if (!(largest >= kSmallestLength)) refuse(what, "the normal is zero");
    if (is_unit(n) && std::abs(flat.offset) <= kLargestLength) return flat;
    const double x = n[0] / largest, y = n[1] / largest, z = n[2] / largest;
    const double length = std::sqrt((x * x + y * y) + z * z);
    const double offset = flat.offset / largest / length;
    if (!(std::abs(offset) <= kLargestLength)) {
      refuse(what, "the offset is not finite or beyond the largest length");
    }
    return {{x / length, y / length, z / length}, offset};
  });
}

Mesh checked(Mesh mesh) {
  return bvh::in_standard_arithmetic([&]() -> Mesh {
    const Aabb& bounds = mesh.bounds();
    check_coordinates(bounds.min, "mesh", "bounds");
    check_coordinates(bounds.max, "mesh", "bounds");
    return mesh;
  });
}

}  // namespace

const char* name_of(ShapeKind kind) {
  constexpr std::array kNames{"sphere", "box",          "capsule",     "cylinder",
                              "cone",   "ellipsoid",    "convex hull", "half-space",
                              "mesh",   "height field", "plane"};
  static_assert(kNames.size() == kShapeKinds.size());
  const auto index = static_cast<std::size_t>(kind);
  if (index >= kNames.size()) throw InputError("shape kind: there is no such kind");
  return kNames[index];
}

Shape::Shape(const Sphere& sphere) : value_(checked(sphere)) {}
Shape::Shape(const Box& box) : value_(checked(box)) {}
Shape::Shape(const Capsule& capsule) : value_(checked(capsule)) {}
Shape::Shape(const Cylinder& cylinder) : value_(checked(cylinder, "cylinder")) {}
Shape::Shape(const Cone& cone) : value_(checked(cone, "cone")) {}
Shape::Shape(const Ellipsoid& ellipsoid) : value_(checked(ellipsoid)) {}
Shape::Shape(ConvexHull hull) : value_(std::move(hull)) {}
Shape::Shape(const HalfSpace& half_space) : value_(checked_flat(half_space, "half-space")) {}
Shape::Shape(Mesh mesh) : value_(checked(std::move(mesh))) {}
Shape::Shape(HeightField field) : value_(std::move(field)) {}
Shape::Shape(const Plane& plane) : value_(checked_flat(plane, "plane")) {}

namespace {

const Pose& identity() {
  static const Pose kIdentity = Pose::Identity();
  return kIdentity;
}

}  // namespace

PlacedShapeView::PlacedShapeView(const Shape& of_shape) : shape(of_shape), pose(identity()) {}

PlacedShapeView::PlacedShapeView(Shape&& of_shape)
    : held_shape_(std::move(of_shape)), shape(*held_shape_), pose(identity()) {}

}  // namespace graze
