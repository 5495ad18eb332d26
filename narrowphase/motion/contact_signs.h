#pragma once

// Decides whether two hulls share a point at one time, when all four points are in one plane, by
// signs of polynomials of degree two.

#include <graze/narrowphase/motion/polynomial.h>

namespace graze::narrowphase {

/// Says which point and which segment are meant, by the corners' numbers in FourPaths.
struct PointInEdge {
  int point;
  int from;
  int to;
};

/// The corners and edges that a point and a triangle, or two edges, come down to where no area is
/// left, and where contact begins while all stays in one plane.
inline constexpr PointInEdge kPointInEdges[2][4] = {
    {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}},
    {{0, 2, 3}, {1, 2, 3}, {2, 0, 1}, {3, 0, 1}},
};

inline const PointInEdge (&point_in_edges(PathPair kind))[4] {
  return kPointInEdges[kind == PathPair::EdgeEdge];
}

/// Returns a polynomial that is zero in each axis while the point is on the line.
inline Polynomial beside_edge(const ExactPaths& paths, const PointInEdge& which, int axis) {
  return cross(paths, {which.from, which.point}, {which.from, which.to}, axis);
}

/// Returns a polynomial that is not positive in any axis while a point of the line is between the
/// ends.
inline Polynomial along_edge(const ExactPaths& paths, const PointInEdge& which, int axis) {
  return product(paths.offset(which.point, which.from, axis),
                 paths.offset(which.point, which.to, axis));
}

template <typename SignOf>
bool is_in_edge(const ExactPaths& paths, const PointInEdge& which, const SignOf& sign_of) {
  for (int axis = 0; axis < 3; ++axis) {
    if (sign_of(beside_edge(paths, which, axis)) != Sign::Zero) return false;
    if (sign_of(along_edge(paths, which, axis)) == Sign::Positive) return false;
  }
  return true;
}

/// Returns (q - p) x (r - p).
inline Polynomial area(const ExactPaths& paths, int p, int q, int r, int axis) {
  return cross(paths, {p, q}, {p, r}, axis);
}

/// True if the point is on the inner side of each edge, seen along an axis along which there is
/// area.
template <typename SignOf>
bool is_in_triangle(const ExactPaths& paths, int axis, Sign turn, const SignOf& sign_of) {
  for (int i = 1; i <= 3; ++i) {
    if (sign_of(area(paths, i, i % 3 + 1, 0, axis)) == -turn) return false;
  }
  return true;
}

/// True if the ends of each edge are not on one side of the other, seen along an axis along which
/// the edges are not parallel.
template <typename SignOf>
bool do_edges_meet(const ExactPaths& paths, int axis, const SignOf& sign_of) {
  for (int i = 0; i <= 2; i += 2) {
    const int other = 2 - i;
    const Sign sign = sign_of(area(paths, i, i + 1, other, axis));
    if (sign != Sign::Zero && sign == sign_of(area(paths, i, i + 1, other + 1, axis))) return false;
  }
  return true;
}

/// Returns the normal of the plane that holds all four points: of the triangle, or of both edges.
inline Polynomial normal(const ExactPaths& paths, PathPair kind, int axis) {
  if (kind == PathPair::PointTriangle) return area(paths, 1, 2, 3, axis);
  return cross(paths, {0, 1}, {2, 3}, axis);
}

/// True if the hulls share a point at a time when all points are in one plane; `sign_of(f)` is the
/// sign of a polynomial then.
template <typename SignOf>
bool do_meet(const ExactPaths& paths, PathPair kind, const SignOf& sign_of) {
  for (int axis = 0; axis < 3; ++axis) {
    const Sign turn = sign_of(normal(paths, kind, axis));
    if (turn == Sign::Zero) continue;
    return kind == PathPair::PointTriangle ? is_in_triangle(paths, axis, turn, sign_of)
                                           : do_edges_meet(paths, axis, sign_of);
  }
  for (const PointInEdge& which : point_in_edges(kind)) {
    if (is_in_edge(paths, which, sign_of)) return true;
  }
  return false;
}

}  // namespace graze::narrowphase
