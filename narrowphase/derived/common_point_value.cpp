#include <graze/narrowphase/derived/common_points.h>
#include <graze/narrowphase/derived/double_pair.h>
#include <graze/narrowphase/derived/simplex.h>
#include <graze/narrowphase/predicates/exact_vector.h>
#include <algorithm>
#include <cmath>
#include <optional>

namespace graze::narrowphase {
namespace {

using Kind = CommonPoint::Kind;
using Corners3 = double[3][3];

/// Names the point of an edge, from + (to - from) * ratio, at which it meets another thing: the
/// plane of a triangle, or the line of an edge in the same plane.
struct EdgePoint {
  const double* from;
  const double* to;
  const double* other[3];  ///< the triangle's corners, or the first two for an edge
  enum class Through { Plane, Line } through;
};

EdgePoint edge_point_of(const CommonPoint& point, const OrderedTriangles& t) {
  const auto edge_and_plane = [](const Corners3& line, int edge, const Corners3& plane) {
    return EdgePoint{line[kEdges[edge][0]],
                     line[kEdges[edge][1]],
                     {plane[0], plane[1], plane[2]},
                     EdgePoint::Through::Plane};
  };
  if (point.kind == Kind::EdgeOfA) return edge_and_plane(t.a, point.a, t.b);
  if (point.kind == Kind::EdgeOfB) return edge_and_plane(t.b, point.b, t.a);
  return {t.a[kEdges[point.a][0]],
          t.a[kEdges[point.a][1]],
          {t.b[kEdges[point.b][0]], t.b[kEdges[point.b][1]], nullptr},
          EdgePoint::Through::Line};
}

/// Returns component `axis` of a cross product.
template <typename Vector>
auto cross_component(const Vector& a, const Vector& b, int axis) {
  if (axis == 0) return a.y * b.z - a.z * b.y;
  if (axis == 1) return a.z * b.x - a.x * b.z;
  return a.x * b.y - a.y * b.x;
}

template <typename Number>
struct Ratio {
  Number numerator;
  Number denominator;
};

/// Returns where the edge meets the plane: h_from / (h_from - h_to), with heights of opposite
/// signs. It is of degree three.
template <typename Minus>
auto ratio_through_plane(const EdgePoint& c, const Minus& minus) {
  const auto normal = cross(minus(c.other[1], c.other[0]), minus(c.other[2], c.other[0]));
  const auto from = dot(normal, minus(c.from, c.other[0]));
  const auto to = dot(normal, minus(c.to, c.other[0]));
  return Ratio<decltype(from - to)>{from, from - to};
}

/// Returns where it meets the line, in the projection along `axis`: (w x v) / (u x v). It is of
/// degree two.
template <typename Minus>
auto ratio_through_line(const EdgePoint& c, int axis, const Minus& minus) {
  const auto v = minus(c.other[1], c.other[0]);
  const auto numerator = cross_component(minus(c.other[0], c.from), v, axis);
  return Ratio<decltype(numerator - numerator)>{numerator,
                                                cross_component(minus(c.to, c.from), v, axis)};
}

double size_of(const double* a, const double* b) {
  return std::max(std::abs(a[0] - b[0]), std::max(std::abs(a[1] - b[1]), std::abs(a[2] - b[2])));
}

/// Returns the axis along which the two edges are least parallel.
int crossing_axis(const EdgePoint& c) {
  int best = 0;
  double best_area = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const Point2 a0 = project(c.from, axis), a1 = project(c.to, axis);
    const Point2 b0 = project(c.other[0], axis), b1 = project(c.other[1], axis);
    const double area = std::abs((a1.x - a0.x) * (b1.y - b0.y) - (a1.y - a0.y) * (b1.x - b0.x));
    if (area > best_area) {
      best = axis;
      best_area = area;
    }
  }
  return best;
}

// Differences between these sizes keep every product of three, and its error terms, in range:
// 2^-300 times 2^-107 is far above what underflow takes, 2^-1074 times 2^200.
constexpr double kSmallest = 0x1p-100;
constexpr double kLargest = 0x1p+100;

// Write w for kPairRoundoff; L for the size of the edge; V for that of the sides of the other, D
// for that of the offset from the edge's start. A height, as kTripleBound has it, is off by 50 w
// V^2 D or 50 w V^2 (D + L), a projected cross product by 8 w D V or 8 w L V. The point moves by L
// times the error of the ratio, which is that of both terms over the denominator; when that is at
// least 2^-36 V^2 L (or L V), by less than 2^-101 + 36 * 150 (D + L) < 2^-57 (D + L). Coordinates
// of size M have D and L at most 2 M: below 2^-55 M, a quarter of an ulp of M.
constexpr double kFlattest = 0x1p-36;

std::optional<std::array<double, 3>> rounded_value(const EdgePoint& c) {
  const double length = size_of(c.to, c.from);
  const double start = size_of(c.from, c.other[0]);
  const bool is_plane = c.through == EdgePoint::Through::Plane;
  const double side =
      std::max(size_of(c.other[1], c.other[0]), is_plane ? size_of(c.other[2], c.other[0]) : 0.0);
  if (!(std::min(length, side) >= kSmallest &&
        std::max(length, std::max(side, start)) <= kLargest)) {
    return std::nullopt;
  }
  const auto ratio = is_plane ? ratio_through_plane(c, PairVector::difference)
                              : ratio_through_line(c, crossing_axis(c), PairVector::difference);
  const double size = is_plane ? side * side * length : side * length;
  if (!(std::abs(ratio.denominator.high) >= kFlattest * size)) return std::nullopt;
  const PairVector offset =
      PairVector::difference(c.to, c.from) * (ratio.numerator / ratio.denominator);
  return std::array<double, 3>{rounded_sum(c.from[0], offset.x), rounded_sum(c.from[1], offset.y),
                               rounded_sum(c.from[2], offset.z)};
}

CommonUnit common_unit(const EdgePoint& c) {
  CommonUnit unit({});
  unit.include(c.from, 3);
  unit.include(c.to, 3);
  for (const double* corner : c.other) {
    if (corner != nullptr) unit.include(corner, 3);
  }
  return unit;
}

/// Returns an axis along which the projection shows the crossing.
int exact_crossing_axis(const EdgePoint& c, const CommonUnit& unit) {
  const BigVector normal = cross(BigVector::difference(c.to, c.from, unit),
                                 BigVector::difference(c.other[1], c.other[0], unit));
  if (normal.x.sign() != Sign::Zero) return 0;
  return normal.y.sign() != Sign::Zero ? 1 : 2;
}

std::array<double, 3> exact_value(const EdgePoint& c) {
  const CommonUnit unit = common_unit(c);
  const auto minus = [&](const double* a, const double* b) {
    return BigVector::difference(a, b, unit);
  };
  auto ratio = c.through == EdgePoint::Through::Plane
                   ? ratio_through_plane(c, minus)
                   : ratio_through_line(c, exact_crossing_axis(c, unit), minus);
  if (ratio.denominator.sign() == Sign::Negative) {
    ratio.denominator = BigInteger() - ratio.denominator;
    ratio.numerator = BigInteger() - ratio.numerator;
  }
  std::array<double, 3> value;
  for (int k = 0; k < 3; ++k) {
    const BigInteger numerator =
        unit.of(c.from[k]) * ratio.denominator + unit(c.to[k], c.from[k]) * ratio.numerator;
    value[k] = rounded_ratio(numerator, ratio.denominator, unit.exponent());
  }
  return value;
}

}  // namespace

std::array<double, 3> value_of(const CommonPoint& point, const OrderedTriangles& triangles) {
  const double* vertex = point.kind == Kind::VertexOfA   ? triangles.a[point.a]
                         : point.kind == Kind::VertexOfB ? triangles.b[point.b]
                                                         : nullptr;
  if (vertex != nullptr) return {vertex[0], vertex[1], vertex[2]};
  const EdgePoint crossing = edge_point_of(point, triangles);
  if (const auto value = rounded_value(crossing)) return *value;
  return exact_value(crossing);
}

}  // namespace graze::narrowphase
