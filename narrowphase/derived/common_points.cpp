// Every corner of the intersection of two convex sets is a corner of one that lies in the other, or
// a point where an edge of one crosses an edge or the inside of the other. Asking for insides makes
// each corner appear once. All of it is decided by signs of orientations.

#include <graze/narrowphase/derived/common_points.h>
#include <graze/narrowphase/derived/simplex.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <utility>

namespace graze::narrowphase {
namespace {

using Kind = CommonPoint::Kind;

/// Holds a simplex, and the sides of the other one's plane that its vertices lie on.
struct Side {
  Simplex simplex;
  Sign sign[3] = {Sign::Zero, Sign::Zero, Sign::Zero};

  bool is_off_plane() const {
    return sign[0] != Sign::Zero && sign[0] == sign[1] && sign[1] == sign[2];
  }
  /// True if the closed edge shares a point with the other's plane.
  bool meets_plane(int edge) const {
    const Sign from = sign[kEdges[edge][0]];
    return from == Sign::Zero || from != sign[kEdges[edge][1]];
  }
  bool crosses_plane(int edge) const {
    const Sign from = sign[kEdges[edge][0]];
    return from != Sign::Zero && from == -sign[kEdges[edge][1]];
  }
};

void find_sides(Side& side, const Simplex& plane) {
  for (int i = 0; i < 3; ++i) {
    side.sign[i] =
        orientation_3d(plane.vertex(0), plane.vertex(1), plane.vertex(2), side.simplex.vertex(i));
  }
}

/// True if an edge that crosses the plane of a triangle passes through its inside.
bool passes_inside(const Simplex& line, int edge, const Simplex& triangle) {
  const double* p = line.edge_start(edge);
  const double* q = line.edge_end(edge);
  const Sign turn = orientation_3d(p, q, triangle.vertex(0), triangle.vertex(1));
  return turn != Sign::Zero &&
         turn == orientation_3d(p, q, triangle.vertex(1), triangle.vertex(2)) &&
         turn == orientation_3d(p, q, triangle.vertex(2), triangle.vertex(0));
}

bool are_opposite(Sign s, Sign t) {
  return s != Sign::Zero && s == -t;
}

/// True if the insides of two edges share one point and the edges are not parallel. The four points
/// are then in one plane: where a projection shows a crossing, it is one to one on that plane;
/// where the edges cross, some projection shows it.
bool edges_cross(const double* a0, const double* a1, const double* b0, const double* b1) {
  if (orientation_3d(a0, a1, b0, b1) != Sign::Zero) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const Point2 p0 = project(a0, axis), p1 = project(a1, axis);
    const Point2 q0 = project(b0, axis), q1 = project(b1, axis);
    if (are_opposite(orientation_2d(p0, p1, q0), orientation_2d(p0, p1, q1)) &&
        are_opposite(orientation_2d(q0, q1, p0), orientation_2d(q0, q1, p1))) {
      return true;
    }
  }
  return false;
}

void add_vertices(CommonPoints& points, const Side& a, const Side& b) {
  for (int i = 0; i < 3; ++i) {
    if (!a.simplex.has_vertex(i)) continue;
    const Location in_b = locate(a.simplex.vertex(i), b.simplex, a.sign[i]);
    if (!in_b.is_inside) continue;
    points.point[points.count++] = {Kind::VertexOfA, i, 0, edges_at_vertex(i), in_b.edges};
  }
  for (int j = 0; j < 3; ++j) {
    if (!b.simplex.has_vertex(j)) continue;
    const Location in_a = locate(b.simplex.vertex(j), a.simplex, b.sign[j]);
    const bool is_vertex = (in_a.edges & (in_a.edges - 1)) != 0;
    if (!in_a.is_inside || is_vertex) continue;
    points.point[points.count++] = {Kind::VertexOfB, 0, j, in_a.edges, edges_at_vertex(j)};
  }
}

void add_edges(CommonPoints& points, const Side& a, const Side& b) {
  for (int edge = 0; edge < 3; ++edge) {
    if (b.simplex.has_area() && a.simplex.has_edge(edge) && a.crosses_plane(edge) &&
        passes_inside(a.simplex, edge, b.simplex)) {
      points.point[points.count++] = {Kind::EdgeOfA, edge, 0, 1u << edge, 0};
    }
    if (a.simplex.has_area() && b.simplex.has_edge(edge) && b.crosses_plane(edge) &&
        passes_inside(b.simplex, edge, a.simplex)) {
      points.point[points.count++] = {Kind::EdgeOfB, 0, edge, 0, 1u << edge};
    }
  }
}

void add_crossings(CommonPoints& points, const Side& a, const Side& b) {
  for (int i = 0; i < 3; ++i) {
    if (!a.simplex.has_edge(i) || !a.meets_plane(i)) continue;
    for (int j = 0; j < 3; ++j) {
      if (!b.simplex.has_edge(j) || !b.meets_plane(j)) continue;
      if (!edges_cross(a.simplex.edge_start(i), a.simplex.edge_end(i), b.simplex.edge_start(j),
                       b.simplex.edge_end(j))) {
        continue;
      }
      points.point[points.count++] = {Kind::EdgeCrossing, i, j, 1u << i, 1u << j};
    }
  }
}

bool share_an_edge(const CommonPoint& p, const CommonPoint& q) {
  return (p.edges_a & q.edges_a) != 0 || (p.edges_b & q.edges_b) != 0;
}

/// Sorts the corners around the polygon. Each edge of it lies on an edge of A or of B, and no such
/// edge holds three corners: two corners are neighbours if and only if they share one.
void sort_around(CommonPoints& points) {
  for (int i = 1; i + 1 < points.count; ++i) {
    for (int j = i; j < points.count; ++j) {
      if (!share_an_edge(points.point[i - 1], points.point[j])) continue;
      std::swap(points.point[i], points.point[j]);
      break;
    }
  }
}

}  // namespace

CommonPoints find_common_points(const OrderedTriangles& triangles) {
  Side a{Simplex(triangles.a)};
  Side b{Simplex(triangles.b)};
  CommonPoints points;
  if (b.simplex.has_area()) find_sides(a, b.simplex);
  if (a.is_off_plane()) return points;
  if (a.simplex.has_area()) find_sides(b, a.simplex);
  if (b.is_off_plane()) return points;
  add_vertices(points, a, b);
  add_edges(points, a, b);
  add_crossings(points, a, b);
  if (points.count > 2) sort_around(points);
  return points;
}

}  // namespace graze::narrowphase
