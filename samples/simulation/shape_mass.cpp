#include "samples/simulation/shape_mass.h"

#include <graze/bvh/error.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "samples/simulation/solid_meshes.h"

namespace graze::samples {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

/// Returns the mass properties of a solid that the axes of its frame are principal axes of.
/// `squares` are the means of x^2, y^2 and z^2 over it, measured from the centre.
MassProperties solid(double mass, const Vector3d& centre, const Vector3d& squares) {
  const Vector3d moments = Vector3d::Constant(squares.sum()) - squares;
  MassProperties result{mass, centre, moments.asDiagonal(), {}};
  result.inverse_inertia = (mass * moments).cwiseInverse().asDiagonal();
  result.inertia *= mass;
  return result;
}

/// A capsule is a cylinder and, at each of its ends, half a ball. A half ball's centre is 3/8 of
/// the radius beyond its flat side, and the mean square of z from that side is a fifth of the
/// radius squared.
MassProperties of_capsule(const Capsule& capsule, double density) {
  const double r = capsule.radius, h = capsule.half_length;
  const double middle = 2 * pi * r * r * h;
  const double ends = 4 * pi / 3 * r * r * r;
  const double across = (middle * r * r / 4 + ends * r * r / 5) / (middle + ends);
  const double along =
      (middle * h * h / 3 + ends * (h * h + 2 * h * 0.375 * r + r * r / 5)) / (middle + ends);
  return solid(density * (middle + ends), Vector3d::Zero(), {across, across, along});
}

/// The centre of a cone is a quarter of its height above the base.
MassProperties of_cone(const Cone& cone, double density) {
  const double r = cone.radius, height = 2 * cone.half_height;
  const double across = 3 * r * r / 20;
  return solid(density * pi * r * r * height / 3, {0, 0, -height / 4},
               {across, across, 3 * height * height / 80});
}

template <typename Corner>
double farthest(std::size_t count, const Vector3d& from, Corner&& corner) {
  double most = 0;
  for (std::size_t i = 0; i < count; ++i)
    most = std::max(most, (Vector3d(corner(i)) - from).norm());
  return most;
}

}  // namespace

MassProperties mass_properties(const Shape& shape, double density) {
  const Vector3d origin = Vector3d::Zero();
  if (const auto* s = shape.as<Sphere>()) {
    const double r = s->radius;
    return solid(density * 4 * pi / 3 * r * r * r, s->centre, Vector3d::Constant(r * r / 5));
  }
  if (const auto* s = shape.as<Box>()) {
    const Vector3d& h = s->half_extents;
    return solid(density * 8 * h.prod(), origin, h.cwiseProduct(h) / 3);
  }
  if (const auto* s = shape.as<Capsule>()) return of_capsule(*s, density);
  if (const auto* s = shape.as<Cylinder>()) {
    const double r = s->radius, h = s->half_height;
    return solid(density * 2 * pi * r * r * h, origin, {r * r / 4, r * r / 4, h * h / 3});
  }
  if (const auto* s = shape.as<Cone>()) return of_cone(*s, density);
  if (const auto* s = shape.as<Ellipsoid>()) {
    const Vector3d& a = s->semi_axes;
    return solid(density * 4 * pi / 3 * a.prod(), s->centre, a.cwiseProduct(a) / 5);
  }
  if (const auto* s = shape.as<ConvexHull>()) return mass_properties(surface_of(*s), density);
  if (const auto* s = shape.as<Mesh>()) return mass_properties(*s, density);
  if (shape.kind() == ShapeKind::HeightField)
    throw InputError("mass of a height field: it has none");
  throw InputError("mass of a half-space: it has none");
}

double bounding_radius_about(const Shape& shape, const Vector3d& point) {
  const auto box = [&](const Vector3d& centre, const Vector3d& half) {
    return (centre - point).norm() + half.norm();
  };
  const Vector3d origin = Vector3d::Zero();
  if (const auto* s = shape.as<Sphere>()) return (s->centre - point).norm() + s->radius;
  if (const auto* s = shape.as<Box>()) return box(origin, s->half_extents);
  if (const auto* s = shape.as<Capsule>()) return point.norm() + s->half_length + s->radius;
  if (const auto* s = shape.as<Cylinder>())
    return point.norm() + std::hypot(s->radius, s->half_height);
  if (const auto* s = shape.as<Cone>()) return point.norm() + std::hypot(s->radius, s->half_height);
  if (const auto* s = shape.as<Ellipsoid>()) {
    return (s->centre - point).norm() + s->semi_axes.maxCoeff();
  }
  if (const auto* s = shape.as<ConvexHull>()) {
    return farthest(s->vertex_count(), point, [&](std::size_t i) { return s->vertex(i); });
  }
  if (const auto* s = shape.as<Mesh>()) {
    return farthest(s->vertices().size(), point, [&](std::size_t i) { return s->vertices()[i]; });
  }
  if (const auto* s = shape.as<HeightField>())
    return box((s->bounds().min + s->bounds().max) / 2, (s->bounds().max - s->bounds().min) / 2);
  throw InputError("bounding radius of a half-space: it has no end");
}

}  // namespace graze::samples
