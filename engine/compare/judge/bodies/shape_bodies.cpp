#include <graze/engine/compare/judge/bodies/shape_bodies.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/shapes/hull_data.h>
#include <graze/narrowphase/convex/core/hull.h>
#include <graze/narrowphase/triangle_distance.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::compare {
namespace {

using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Finds the largest d . x over the shape in its own frame.
struct Support {
  const Vector3d& d;
  double flat = std::hypot(d.x(), d.y());

  double operator()(const Sphere& s) const { return d.dot(s.centre) + s.radius * d.norm(); }
  double operator()(const Box& s) const { return d.cwiseAbs().dot(s.half_extents); }
  double operator()(const Capsule& s) const {
    return std::abs(d.z()) * s.half_length + s.radius * d.norm();
  }
  double operator()(const Cylinder& s) const {
    return flat * s.radius + std::abs(d.z()) * s.half_height;
  }
  double operator()(const Cone& s) const {
    return std::max(d.z() * s.half_height, flat * s.radius - d.z() * s.half_height);
  }
  double operator()(const Ellipsoid& s) const {
    return d.dot(s.centre) + d.cwiseProduct(s.semi_axes).norm();
  }
  double operator()(const ConvexHull& s) const {
    double most = -kInfinity;
    for (std::size_t i = 0; i < s.vertex_count(); ++i)
      most = std::max(most, d.dot(s.vertex(i)));
    return most;
  }
  double operator()(const HalfSpace& s) const {
    return (d - s.normal).norm() < 1e-7 ? s.offset : kInfinity;
  }
  double operator()(const Plane& s) const {
    return (d + s.normal).norm() < 1e-7 ? -s.offset : (*this)(HalfSpace{s.normal, s.offset});
  }
  double operator()(const HeightField& s) const { return (*this)(s.mesh()); }
  double operator()(const Mesh& s) const {
    double most = -kInfinity;
    for (const Vector3d& v : s.vertices())
      most = std::max(most, d.dot(v));
    return most;
  }
};

/// Finds how far the point is outside of the shape, both in the shape's frame.
struct Outside {
  const Vector3d& p;
  double rho = std::hypot(p.x(), p.y());

  double operator()(const Sphere& s) const { return (p - s.centre).norm() - s.radius; }
  double operator()(const Box& s) const { return (p.cwiseAbs() - s.half_extents).maxCoeff(); }
  double operator()(const Capsule& s) const {
    return std::hypot(rho, std::max(std::abs(p.z()) - s.half_length, 0.0)) - s.radius;
  }
  double operator()(const Cylinder& s) const {
    return std::max(rho - s.radius, std::abs(p.z()) - s.half_height);
  }
  double operator()(const Cone& s) const {
    // The lateral surface is rho = radius (half_height - z) / (2 half_height).
    const double height = 2 * s.half_height;
    const double steep = height / std::hypot(s.radius, height);
    const double beside = steep * (rho - s.radius * (s.half_height - p.z()) / height);
    return std::max(-s.half_height - p.z(), beside);
  }
  double operator()(const Ellipsoid& s) const {
    const Vector3d q = p - s.centre;
    const double ratio = q.cwiseQuotient(s.semi_axes).norm();  // 1 on the surface
    return ratio > 1 ? q.norm() * (1 - 1 / ratio) : (ratio - 1) * s.semi_axes.minCoeff();
  }
  double operator()(const ConvexHull& s) const {
    const narrowphase::Hull& hull = data_of(s);
    double most = -kInfinity;
    for (const auto& face : hull.faces) {
      const narrowphase::Vec3 v = hull.corners[hull.loops[face.first]] + hull.middle;
      const Vector3d n(face.normal.x, face.normal.y, face.normal.z);
      most = std::max(most, n.dot(p - Vector3d(v.x, v.y, v.z)));
    }
    return most;
  }
  double operator()(const HalfSpace& s) const { return s.normal.dot(p) - s.offset; }
  double operator()(const Plane& s) const { return std::abs(s.normal.dot(p) - s.offset); }
  double operator()(const HeightField& s) const { return (*this)(s.mesh()); }
  double operator()(const Mesh& s) const {
    double least = kInfinity;
    for (std::size_t i = 0; i < s.triangles().size(); ++i)
      least = std::min(least, distance(s.triangle(i), Triangle{p, p, p}).distance);
    return least;
  }
};

}  // namespace

std::optional<HalfSpace> flat_of(const Shape& shape) {
  if (const auto* plane = shape.as<Plane>()) return HalfSpace{plane->normal, plane->offset};
  if (const auto* half_space = shape.as<HalfSpace>()) return *half_space;
  return std::nullopt;
}

double support_along(const Shape& shape, const Pose& pose, const Vector3d& n) {
  const Vector3d d = pose.linear().transpose() * n;
  return n.dot(pose.translation()) + std::visit(Support{d}, shape.value());
}

double outside_by(const Shape& shape, const Pose& pose, const Vector3d& point) {
  const Vector3d p = pose.linear().transpose() * (point - pose.translation());
  return std::visit(Outside{p}, shape.value());
}

}  // namespace graze::compare
