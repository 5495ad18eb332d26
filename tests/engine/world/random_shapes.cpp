#include "tests/engine/world/random_shapes.h"

#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/shapes/hull_data.h>
#include <graze/narrowphase/convex/core/hull.h>
#include <graze/narrowphase/triangle_distance.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/shapes/formula_meshes.h"

namespace graze::tests {

using Eigen::Vector3d;

Shape random_shape(ShapeKind kind, double size, RandomSource& source) {
  const auto length = [&] { return size * std::exp2(source.uniform(-2, 0)); };
  const double a = length(), b = length(), c = length();
  const Vector3d centre = source.vector(-0.2, 0.2) * size;
  switch (kind) {
    case ShapeKind::Sphere:
      return Sphere{centre, a};
    case ShapeKind::Box:
      return Box{{a, b, c}};
    case ShapeKind::Capsule:
      return Capsule{a, b};
    case ShapeKind::Cylinder:
      return Cylinder{a, b};
    case ShapeKind::Cone:
      return Cone{a, b};
    case ShapeKind::Ellipsoid:
      return Ellipsoid{centre, {a, b, c}};
    case ShapeKind::ConvexHull: {
      std::vector<Vector3d> points;
      const int count = static_cast<int>(source.integer(4, 24));
      for (int i = 0; i < count; ++i)
        points.push_back(source.vector(-1, 1).cwiseProduct(Vector3d(a, b, c)));
      return ConvexHull(points);
    }
    case ShapeKind::HalfSpace:
    case ShapeKind::Plane: {
      const Vector3d normal = source.vector(-1, 1);
      const double offset = source.uniform(-0.2, 0.2) * size * normal.norm();
      if (kind == ShapeKind::Plane) return Plane{normal, offset};
      return HalfSpace{normal, offset};
    }
    default:
      return make_torus(a, 0.4 * a, 10, 6);
  }
}

namespace {

double outside_of_ellipsoid(const Vector3d& semi, const Vector3d& p) {
  // Scaling p onto the surface moves it by |p| (1 - 1 / k): no nearer than the surface is.
  const double k = p.cwiseQuotient(semi).norm();
  return k <= 1 ? 0 : p.norm() * (1 - 1 / k);
}

double outside_of_planes(const narrowphase::Hull& hull, const Vector3d& p) {
  double most = -std::numeric_limits<double>::infinity();
  for (const auto& face : hull.faces) {
    const narrowphase::Vec3 v = hull.corners[hull.loops[face.first]] + hull.middle;
    const Vector3d n(face.normal.x, face.normal.y, face.normal.z);
    most = std::max(most, n.dot(p - Vector3d(v.x, v.y, v.z)));
  }
  return most;
}

double outside_of_mesh(const Mesh& mesh, const Vector3d& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i)
    least = std::min(least, distance(mesh.triangle(i), Triangle{p, p, p}).distance);
  return least;
}

double beyond_disc(double rho, double radius) {
  return std::max(rho - radius, 0.0);
}

}  // namespace

double outside_by(const Shape& shape, const Pose& pose, const Vector3d& point) {
  const Vector3d p = pose.linear().transpose() * (point - pose.translation());
  const double rho = std::hypot(p.x(), p.y());
  if (const auto* s = shape.as<Sphere>()) return (p - s->centre).norm() - s->radius;
  if (const auto* s = shape.as<Box>()) return (p.cwiseAbs() - s->half_extents).maxCoeff();
  if (const auto* s = shape.as<Capsule>()) {
    const double z = std::max(std::abs(p.z()) - s->half_length, 0.0);
    return std::hypot(rho, z) - s->radius;
  }
  if (const auto* s = shape.as<Cylinder>()) {
    return std::max(rho - s->radius, std::abs(p.z()) - s->half_height);
  }
  if (const auto* s = shape.as<Cone>()) {
    const double z = p.z() / s->half_height;
    const double wide = 0.5 * (1 - z) * s->radius;
    const double steep = 2 * s->half_height / std::hypot(s->radius, 2 * s->half_height);
    return std::max(std::abs(p.z()) - s->half_height,
                    steep * beyond_disc(rho, std::max(wide, 0.0)));
  }
  if (const auto* s = shape.as<Ellipsoid>()) {
    return outside_of_ellipsoid(s->semi_axes, p - s->centre);
  }
  if (const auto* s = shape.as<ConvexHull>()) return outside_of_planes(data_of(*s), p);
  if (const auto* s = shape.as<HalfSpace>()) return s->normal.dot(p) - s->offset;
  return outside_of_mesh(*shape.as<Mesh>(), p);
}

double reach_along(const Shape& shape, const Pose& pose, const Vector3d& n) {
  const Vector3d d = pose.linear().transpose() * n;
  const double flat = std::hypot(d.x(), d.y());
  const double base = n.dot(pose.translation());
  if (const auto* s = shape.as<Sphere>()) return base + d.dot(s->centre) + s->radius;
  if (const auto* s = shape.as<Box>()) return base + d.cwiseAbs().dot(s->half_extents);
  if (const auto* s = shape.as<Capsule>()) {
    return base + std::abs(d.z()) * s->half_length + s->radius;
  }
  if (const auto* s = shape.as<Cylinder>()) {
    return base + flat * s->radius + std::abs(d.z()) * s->half_height;
  }
  if (const auto* s = shape.as<Cone>()) {
    return base + std::max(d.z() * s->half_height, flat * s->radius - d.z() * s->half_height);
  }
  if (const auto* s = shape.as<Ellipsoid>()) {
    return base + d.dot(s->centre) + d.cwiseProduct(s->semi_axes).norm();
  }
  if (const auto* s = shape.as<ConvexHull>()) {
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < s->vertex_count(); ++i)
      most = std::max(most, d.dot(s->vertex(i)));
    return base + most;
  }
  if (const auto* s = shape.as<HalfSpace>()) {
    const bool is_bounded = (d - s->normal).norm() < 1e-7;
    return is_bounded ? base + s->offset : std::numeric_limits<double>::infinity();
  }
  double most = -std::numeric_limits<double>::infinity();
  for (const Vector3d& v : shape.as<Mesh>()->vertices())
    most = std::max(most, d.dot(v));
  return base + most;
}

double size_of(const Shape& shape) {
  if (shape.kind() == ShapeKind::HalfSpace) return 1;
  double most = 0;
  for (int i = 0; i < 3; ++i) {
    for (const double sign : {-1.0, 1.0}) {
      const Vector3d n = Vector3d::Unit(i) * sign;
      most = std::max(most, std::abs(reach_along(shape, Pose::Identity(), n)));
    }
  }
  return 1.7320508 * most;
}

}  // namespace graze::tests
