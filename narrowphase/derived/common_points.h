#pragma once

#include <array>

#include <graze/narrowphase/derived/simplex.h>

namespace graze::narrowphase {

/// Names a corner of the intersection of two triangles by what it is made of.
struct CommonPoint {
  enum class Kind {
    VertexOfA,     ///< vertex `a` of A, in B
    VertexOfB,     ///< vertex `b` of B, in A and no vertex of A
    EdgeOfA,       ///< the inside of edge `a` of A crosses the inside of B
    EdgeOfB,       ///< the inside of edge `b` of B crosses the inside of A
    EdgeCrossing,  ///< the insides of edge `a` and edge `b`, which are not parallel, cross
  };
  Kind kind;
  int a;
  int b;
  unsigned edges_a;  ///< the edges of A that it lies on, as in simplex.h
  unsigned edges_b;
};

/// Holds all corners of the intersection, each once, exactly: none, a point, the ends of a segment,
/// or the corners of a convex polygon, which follow each other around it.
struct CommonPoints {
  std::array<CommonPoint, 6> point;
  int count = 0;
};

CommonPoints find_common_points(const OrderedTriangles& triangles);

/// Returns the coordinates, off by at most 2 ulp of the largest coordinate of the triangles:
/// rounded from twice the precision where that is enough, from integers where it is not.
std::array<double, 3> value_of(const CommonPoint& point, const OrderedTriangles& triangles);

}  // namespace graze::narrowphase
