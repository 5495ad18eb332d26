#include <graze/engine/compare/judge/rational/rational_box.h>

#include <utility>

namespace graze::compare {
namespace {

RationalPoint moved(const RationalPoint& p, const RationalPoint& direction, const mpq_class& by) {
  return {p[0] + direction[0] * by, p[1] + direction[1] * by, p[2] + direction[2] * by};
}

std::vector<RationalPoint> corners_of(const RationalBox& box) {
  std::vector<RationalPoint> corners;
  for (unsigned mask = 0; mask < 8; ++mask) {
    RationalPoint corner = box.centre;
    for (std::size_t i = 0; i < 3; ++i)
      corner = moved(corner, box.columns[i],
                     (mask >> i & 1U) == 0 ? mpq_class(-box.half[i]) : box.half[i]);
    corners.push_back(corner);
  }
  return corners;
}

using Directions = std::vector<RationalPoint>;

/// Returns the normals that bound the difference of two convex bodies: those of both, and those
/// across each pair of edges. For flat bodies these are also the normals of their edges within
/// their planes; normals too many change nothing, for no normal parts bodies that meet.
Directions axes_of(const Directions& normals_a, const Directions& edges_a,
                   const Directions& normals_b, const Directions& edges_b) {
  Directions axes = normals_a;
  axes.insert(axes.end(), normals_b.begin(), normals_b.end());
  for (const RationalPoint& a : edges_a) {
    for (const RationalPoint& b : edges_b)
      axes.push_back(cross(a, b));
  }
  for (const auto& [normals, edges] :
       {std::pair(&normals_a, &edges_a), std::pair(&normals_b, &edges_b)}) {
    for (const RationalPoint& normal : *normals) {
      for (const RationalPoint& edge : *edges)
        axes.push_back(cross(normal, edge));
    }
  }
  return axes;
}

Directions normals_of(const RationalBox& box) {
  return {cross(box.columns[1], box.columns[2]), cross(box.columns[2], box.columns[0]),
          cross(box.columns[0], box.columns[1])};
}

Directions edges_of(const RationalBox& box) {
  return {box.columns.begin(), box.columns.end()};
}

template <typename Points>
Extent range_of(const Points& points, const RationalPoint& axis) {
  Extent range{dot(points[0], axis), dot(points[0], axis)};
  for (const RationalPoint& point : points) {
    const mpq_class value = dot(point, axis);
    if (value < range.min) range.min = value;
    if (value > range.max) range.max = value;
  }
  return range;
}

template <typename PointsA, typename PointsB>
std::optional<mpq_class> least_translation(const PointsA& a, const PointsB& b,
                                           const Directions& axes) {
  std::optional<mpq_class> best;
  for (const RationalPoint& axis : axes) {
    const mpq_class length = dot(axis, axis);
    if (length == 0) continue;
    const Extent in_a = range_of(a, axis);
    const Extent in_b = range_of(b, axis);
    for (const mpq_class& overlap :
         {mpq_class(in_a.max - in_b.min), mpq_class(in_b.max - in_a.min)}) {
      if (overlap < 0) return std::nullopt;
      const mpq_class square = overlap * overlap / length;
      if (!best || square < *best) best = square;
    }
  }
  return best;
}

}  // namespace

RationalBox exactly(const Aabb& box) {
  RationalBox result;
  const RationalPoint min = exactly(box.min);
  const RationalPoint max = exactly(box.max);
  for (std::size_t i = 0; i < 3; ++i) {
    result.centre[i] = (min[i] + max[i]) / 2;
    result.half[i] = (max[i] - min[i]) / 2;
    for (std::size_t k = 0; k < 3; ++k)
      result.columns[i][k] = i == k ? 1 : 0;
  }
  return result;
}

RationalBox exactly(const Obb& box) {
  RationalBox result;
  result.centre = exactly(Eigen::Vector3d(box.pose.translation()));
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    result.columns[at] = exactly(Eigen::Vector3d(box.pose.linear().col(i)));
    result.half[at] = mpq_class(box.half_extents[i]);
  }
  return result;
}

// The inverse of R^T has the columns c1 x c2 / det, and so on.
RationalBox exactly_by_frame(const Obb& box) {
  RationalBox result = exactly(box);
  const std::array<RationalPoint, 3> c = result.columns;
  const mpq_class determinant = dot(c[0], cross(c[1], c[2]));
  for (std::size_t i = 0; i < 3; ++i) {
    result.columns[i] = cross(c[(i + 1) % 3], c[(i + 2) % 3]);
    for (mpq_class& x : result.columns[i])
      x /= determinant;
  }
  return result;
}

std::vector<RationalTriangle> faces_of(const RationalBox& box) {
  const std::vector<RationalPoint> p = corners_of(box);
  std::vector<RationalTriangle> faces;
  constexpr std::array<std::array<std::size_t, 4>, 6> kFaces = {
      {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};
  for (const auto& f : kFaces) {
    faces.push_back({p[f[0]], p[f[1]], p[f[2]]});
    faces.push_back({p[f[0]], p[f[2]], p[f[3]]});
  }
  return faces;
}

std::optional<mpq_class> squared_overlap(const RationalBox& a, const RationalBox& b) {
  return least_translation(corners_of(a), corners_of(b),
                           axes_of(normals_of(a), edges_of(a), normals_of(b), edges_of(b)));
}

std::optional<mpq_class> squared_overlap(const RationalTriangle& triangle, const RationalBox& box) {
  const Directions edges = {edge_of(triangle, 0), edge_of(triangle, 1), edge_of(triangle, 2)};
  return least_translation(
      triangle, corners_of(box),
      axes_of({cross(edges[0], edges[1])}, edges, normals_of(box), edges_of(box)));
}

mpq_class squared_gap(const RationalBox& a, const RationalBox& b) {
  std::optional<mpq_class> best;
  for (const RationalTriangle& face : faces_of(a)) {
    const mpq_class square = squared_gap(face, b);
    if (!best || square < *best) best = square;
  }
  return *best;
}

mpq_class squared_gap(const RationalTriangle& triangle, const RationalBox& box) {
  std::optional<mpq_class> best;
  for (const RationalTriangle& face : faces_of(box)) {
    const mpq_class square = squared_distance(triangle, face);
    if (!best || square < *best) best = square;
  }
  return *best;
}

}  // namespace graze::compare
