#include "tests/engine/rational_containment.h"

#include <gmpxx.h>
#include <array>
#include <optional>
#include <stdexcept>
#include <vector>

#include "tests/shapes/random_source.h"

namespace graze::oracle {
namespace {

using Vector = std::array<mpq_class, 3>;

Vector minus(const Vector& p, const Vector& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

Vector cross(const Vector& p, const Vector& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

mpq_class dot(const Vector& p, const Vector& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

bool is_zero(const Vector& v) {
  return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

/// A triangle seen from the point, which is the origin.
using Seen = std::array<Vector, 3>;

bool is_on_segment(const Vector& a, const Vector& b) {
  return is_zero(cross(a, b)) && dot(a, b) <= 0;
}

bool is_on(const Seen& t) {
  const Vector normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  if (is_zero(normal)) {
    return is_on_segment(t[0], t[1]) || is_on_segment(t[1], t[2]) || is_on_segment(t[2], t[0]);
  }
  if (dot(normal, t[0]) != 0) return false;
  for (int i = 0; i < 3; ++i) {
    if (dot(cross(t[i], t[(i + 1) % 3]), normal) < 0) return false;
  }
  return true;
}

/// Whether the ray crosses the inside of the triangle, on which the point does not lie; nothing if
/// its line meets an edge or lies in the triangle's plane.
std::optional<bool> crosses(const Seen& t, const Vector& direction) {
  const Vector normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  if (is_zero(normal)) return false;  // nothing but edges: crossings are counted elsewhere
  if (dot(normal, direction) == 0) return std::nullopt;
  if (dot(normal, t[0]) == 0) return false;  // the line leaves the plane in the point
  int left = 0, right = 0;
  for (int i = 0; i < 3; ++i) {
    const int side = sgn(dot(direction, cross(t[i], t[(i + 1) % 3])));
    left += side > 0;
    right += side < 0;
  }
  if (left > 0 && right > 0) return false;
  if (left + right < 3) return std::nullopt;
  return sgn(dot(normal, t[0])) == sgn(dot(normal, direction));
}

std::optional<bool> is_odd(const std::vector<Seen>& triangles, const Vector& direction) {
  bool is_inside = false;
  for (const Seen& triangle : triangles) {
    const std::optional<bool> is_crossing = crosses(triangle, direction);
    if (!is_crossing) return std::nullopt;
    is_inside ^= *is_crossing;
  }
  return is_inside;
}

}  // namespace

bool contains_by_slanted_ray(const Mesh& mesh, const Eigen::Vector3d& point) {
  std::vector<Seen> triangles;
  const Vector origin{point[0], point[1], point[2]};
  for (const TriangleIndices& indices : mesh.triangles()) {
    Seen triangle;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d& p = mesh.vertices()[indices[i]];
      triangle[i] = minus({p[0], p[1], p[2]}, origin);
    }
    if (is_on(triangle)) return true;
    triangles.push_back(triangle);
  }
  RandomSource source(20);
  for (int attempt = 0; attempt < 100; ++attempt) {
    const Eigen::Vector3d d = source.lattice_point(-10007, 10007);
    const std::optional<bool> is_inside = is_odd(triangles, {d[0], d[1], d[2]});
    if (is_inside) return *is_inside;
  }
  throw std::logic_error("no direction found that meets no edge");
}

}  // namespace graze::oracle
