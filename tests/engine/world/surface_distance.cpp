#include "tests/engine/world/surface_distance.h"

#include <graze/narrowphase/triangle_distance.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::tests {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

std::vector<Triangle> facets_of(const ConvexHull& hull) {
  std::vector<Vector3d> corners;
  double size = 0;
  for (std::size_t i = 0; i < hull.vertex_count(); ++i) {
    corners.push_back(hull.vertex(i));
    size = std::max(size, corners.back().norm());
  }
  std::vector<Triangle> facets;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      for (std::size_t k = j + 1; k < corners.size(); ++k) {
        Vector3d normal = (corners[j] - corners[i]).cross(corners[k] - corners[i]);
        if (!(normal.norm() > 0)) continue;
        normal.normalize();
        double high = 0, low = 0;
        for (const Vector3d& corner : corners) {
          const double above = normal.dot(corner - corners[i]);
          high = std::max(high, above), low = std::min(low, above);
        }
        if (std::min(high, -low) < 1e-13 * size)
          facets.push_back({corners[i], corners[j], corners[k]});
      }
    }
  }
  return facets;
}

double to_segment(const Vector2d& from, const Vector2d& to, const Vector2d& p) {
  const Vector2d way = to - from;
  const double share = std::clamp(way.dot(p - from) / way.squaredNorm(), 0.0, 1.0);
  return (from + share * way - p).norm();
}

/// Of a box about the origin, in any dimension.
template <typename Vector>
double to_box(const Vector& half, const Vector& p) {
  const Vector out = p.cwiseAbs() - half;
  const double most = out.maxCoeff();
  return most <= 0 ? -most : out.cwiseMax(0.0).norm();
}

}  // namespace

Surface::Surface(const Shape& shape) : shape_(shape) {
  if (const auto* hull = shape.as<ConvexHull>()) triangles_ = facets_of(*hull);
  const auto* mesh = shape.as<Mesh>();
  for (std::size_t i = 0; mesh != nullptr && i < mesh->triangles().size(); ++i)
    triangles_.push_back(mesh->triangle(i));
}

double Surface::distance(const Pose& pose, const Vector3d& point) const {
  const Vector3d p = pose.linear().transpose() * (point - pose.translation());
  const Vector2d profile(std::hypot(p.x(), p.y()), p.z());
  if (const auto* s = shape_.as<Sphere>()) return std::abs((p - s->centre).norm() - s->radius);
  if (const auto* s = shape_.as<Box>()) return to_box(s->half_extents, p);
  if (const auto* s = shape_.as<Capsule>()) {
    const Vector3d end(0, 0, std::clamp(p.z(), -s->half_length, s->half_length));
    return std::abs((p - end).norm() - s->radius);
  }
  if (const auto* s = shape_.as<Cylinder>()) {
    return to_box(Vector2d(s->radius, s->half_height), profile);
  }
  if (const auto* s = shape_.as<Cone>()) {
    const Vector2d rim(s->radius, -s->half_height), apex(0, s->half_height);
    return std::min(to_segment({0, -s->half_height}, rim, profile), to_segment(rim, apex, profile));
  }
  if (const auto* s = shape_.as<Ellipsoid>()) {
    const Vector3d from = p - s->centre;
    const double k = from.cwiseQuotient(s->semi_axes).norm();
    if (!(k > 0)) return s->semi_axes.minCoeff();
    // Along the gradient of k near the surface, else towards the middle.
    const double slope = from.cwiseQuotient(s->semi_axes.cwiseAbs2()).norm() / k;
    return std::abs(k - 1) < 1e-4 ? std::abs(k - 1) / slope : from.norm() * std::abs(1 - 1 / k);
  }
  if (const auto* s = shape_.as<HalfSpace>()) return std::abs(s->normal.dot(p) - s->offset);
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& triangle : triangles_)
    least = std::min(least, graze::distance(triangle, Triangle{p, p, p}).distance);
  return least;
}

}  // namespace graze::tests
