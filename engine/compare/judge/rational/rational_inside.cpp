#include <gmpxx.h>
#include <graze/engine/compare/judge/rational/rational_inside.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace graze::compare {
namespace {

struct Range {
  double min;
  double max;
  bool holds(double x) const { return min <= x && x <= max; }
};

Range range_of(const Triangle& t, int axis) {
  return {std::min({t.a[axis], t.b[axis], t.c[axis]}), std::max({t.a[axis], t.b[axis], t.c[axis]})};
}

/// True if the moved point lies in the triangle's shadow on the plane of y and z.
bool is_in_shadow(const RationalTriangle& t, const RationalPoint& p) {
  bool is_inside = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint& from = t[i];
    const RationalPoint& to = t[(i + 1) % 3];
    if ((from[2] > p[2]) == (to[2] > p[2])) continue;
    const mpq_class y = from[1] + (p[2] - from[2]) / (to[2] - from[2]) * (to[1] - from[1]);
    is_inside ^= y > p[1];
  }
  return is_inside;
}

/// True if the triangle, which casts a shadow on the point, is at larger x.
bool is_ahead(const RationalTriangle& t, const RationalPoint& p) {
  const RationalPoint normal = cross(edge_of(t, 0), edge_of(t, 1));
  // normal . (x, p_y, p_z) = normal . t[0] at the x sought; normal[0] is the shadow's area.
  const RationalPoint offset = minus(t[0], p);
  return dot(normal, offset) / normal[0] > 0;
}

}  // namespace

bool is_on_surface(const std::vector<Triangle>& surface, const Eigen::Vector3d& point) {
  const RationalTriangle there = exactly(Triangle{point, point, point});
  return std::any_of(surface.begin(), surface.end(), [&](const Triangle& t) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!range_of(t, axis).holds(point[axis])) return false;
    }
    return squared_distance(exactly(t), there) == 0;
  });
}

bool is_enclosed(const std::vector<Triangle>& surface, const Eigen::Vector3d& point) {
  const RationalPoint p = exactly(point);
  bool is_inside = false;
  for (const Triangle& t : surface) {
    const bool may_be_met = range_of(t, 0).max >= point.x() && range_of(t, 1).holds(point.y()) &&
                            range_of(t, 2).holds(point.z());
    if (!may_be_met) continue;
    const RationalTriangle exact = exactly(t);
    if (is_in_shadow(exact, p)) is_inside ^= is_ahead(exact, p);
  }
  return is_inside;
}

std::vector<std::uint32_t> one_of_each_part(const Mesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.vertices().size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root_of = [&](std::uint32_t i) {
    while (parent[i] != i)
      i = parent[i] = parent[parent[i]];
    return i;
  };
  std::vector<bool> is_used(parent.size());
  for (const TriangleIndices& triangle : mesh.triangles()) {
    const std::uint32_t root = root_of(triangle[0]);
    for (const std::uint32_t vertex : triangle) {
      parent[root_of(vertex)] = root;
      is_used[vertex] = true;
    }
  }
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t i = 0; i < parent.size(); ++i) {
    if (is_used[i] && root_of(i) == i) vertices.push_back(i);
  }
  return vertices;
}

}  // namespace graze::compare
