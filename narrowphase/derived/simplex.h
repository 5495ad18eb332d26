#pragma once

#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/triangle.h>

namespace graze::narrowphase {

/// Holds two triangles in the one order in which derived values are computed (law 4): the corners
/// of each ascend lexicographically, and so do the triangles. Negative zeros have become positive.
struct OrderedTriangles {
  double a[3][3];
  double b[3][3];
  bool is_swapped;  ///< true if `a` holds what was given as B
};

OrderedTriangles ordered(const Triangle& triangle_a, const Triangle& triangle_b);

/// The three edges of a triangle whose corners ascend. Each edge ascends too, so that triangles
/// that share an edge compute the same numbers for it.
inline constexpr int kEdges[3][2] = {{0, 1}, {1, 2}, {0, 2}};

/// Says what a triangle whose corners ascend lexicographically is: a triangle with area, the
/// segment between its corners 0 and 2, or the point 0. Vertices and edges keep their numbers.
struct Simplex {
  explicit Simplex(const double (&corners)[3][3]);

  const double* vertex(int i) const { return corner_[i]; }
  const double* edge_start(int edge) const { return corner_[kEdges[edge][0]]; }
  const double* edge_end(int edge) const { return corner_[kEdges[edge][1]]; }

  bool has_area() const { return axis_ >= 0; }
  bool is_point() const { return is_point_; }
  bool has_vertex(int i) const { return i == 0 || has_area() || (i == 2 && !is_point_); }
  bool has_edge(int edge) const { return has_area() || (edge == 2 && !is_point_); }

  /// Return the axis along which the projection has area, and the sense in which its corners turn
  /// there.
  int axis() const { return axis_; }
  Sign turn() const { return turn_; }

 private:
  const double* corner_[3];
  int axis_ = -1;
  Sign turn_ = Sign::Zero;
  bool is_point_ = false;
};

/// The part of a triangle that a point lies in, as a set of edges that it lies on: all bits clear
/// for the inside, one for an edge, two for a vertex.
struct Location {
  bool is_inside;
  unsigned edges;
};

/// Finds where `point` lies in the closed simplex, exactly. `side` is its side of the plane, for a
/// simplex that has area.
Location locate(const double* point, const Simplex& simplex, Sign side);

/// Returns the edges that meet at a vertex.
constexpr unsigned edges_at_vertex(int vertex) {
  constexpr unsigned kMeeting[3] = {0b101, 0b011, 0b110};
  return kMeeting[vertex];
}

}  // namespace graze::narrowphase
