#pragma once

// When are points of two features nearest? For convex sets: p of A and q of B are, if and only if A
// lies behind the plane through p, and B beyond the plane through q, whose normal is q - p. For
// triangles these are claims about their vertices, and each claim is the sign of a product of
// differences. Each function below takes the claims one by one to a `Proof`, whose holds_* answer
// "not negative", either exactly or only where surely positive. Two triangles x and y that do not
// meet, corners in ascending order.

#include <graze/narrowphase/derived/sign_of_products.h>
#include <graze/narrowphase/derived/simplex.h>
#include <utility>

namespace graze::narrowphase {

using TriangleCorners = double[3][3];

/// True if no vertex of x is further along q - p than vertex p, and none of y is less far along it
/// than vertex q.
template <typename Proof>
bool are_nearest_vertices(const Proof& proof, const TriangleCorners& x, int i,
                          const TriangleCorners& y, int j) {
  const Step offset{x[i], y[j]};
  for (int k = 1; k < 3; ++k) {
    if (!proof.holds_dot({x[(i + k) % 3], x[i]}, offset)) return false;
    if (!proof.holds_dot({y[j], y[(j + k) % 3]}, offset)) return false;
  }
  return true;
}

/// True if vertex p of x and its foot on edge e of y are nearest: with w from the edge's start to
/// p, the step from p to the foot is (w.e) e - (e.e) w, times something positive, and v . that is
/// (w x e) . (e x v).
template <typename Proof>
bool are_nearest_vertex_and_edge(const Proof& proof, const TriangleCorners& x, int i,
                                 const TriangleCorners& y, int edge) {
  const double* p = x[i];
  const Step e{y[kEdges[edge][0]], y[kEdges[edge][1]]};
  const Step w{e.from, p};
  if (!proof.has_length(e)) return false;
  if (!proof.holds_dot(w, e) || !proof.holds_dot({p, e.to}, e)) return false;
  for (int k = 1; k < 3; ++k) {
    if (!proof.holds_cross_products(w, e, e, {x[(i + k) % 3], p})) return false;
  }
  const double* opposite = y[3 - kEdges[edge][0] - kEdges[edge][1]];
  return proof.holds_cross_products(w, e, e, {e.from, opposite});
}

/// True if vertex p of x and its foot on the face of y are nearest: the rest of x lies beyond p, as
/// seen from the plane, and p is above the inside of each edge.
template <typename Proof>
bool are_nearest_vertex_and_face(const Proof& proof, const TriangleCorners& x, int i,
                                 const TriangleCorners& y) {
  const double* p = x[i];
  const Step f{y[0], y[1]};
  const Step g{y[0], y[2]};
  const Sign side = proof.side(f, g, {y[0], p});
  if (side == Sign::Zero) return false;
  for (int k = 1; k < 3; ++k) {
    const Step up{p, x[(i + k) % 3]};
    if (!proof.holds_triple(f, g, side == Sign::Positive ? up : -up)) return false;
  }
  for (int k = 0; k < 3; ++k) {
    const Step edge{y[k], y[(k + 1) % 3]};
    if (!proof.holds_cross_products(edge, {y[k], p}, f, g)) return false;
  }
  return true;
}

/// True if points inside two edges, which are not parallel, are nearest: the step between them is
/// along their cross product n = u x v. With w from the start of u to that of v, the nearest points
/// of the lines are at (w x v) . n / n^2 along u and at (w x u) . n / n^2 along v.
template <typename Proof>
bool are_nearest_edges(const Proof& proof, const TriangleCorners& x, int edge_x,
                       const TriangleCorners& y, int edge_y) {
  const Step u{x[kEdges[edge_x][0]], x[kEdges[edge_x][1]]};
  const Step v{y[kEdges[edge_y][0]], y[kEdges[edge_y][1]]};
  const Step w{u.from, v.from};
  const Sign side = proof.side(u, v, w);
  if (side == Sign::Zero) return false;
  const double* opposite_x = x[3 - kEdges[edge_x][0] - kEdges[edge_x][1]];
  const double* opposite_y = y[3 - kEdges[edge_y][0] - kEdges[edge_y][1]];
  const Step back{opposite_x, u.from};
  const Step on{v.from, opposite_y};
  const bool is_along = side == Sign::Positive;
  return proof.holds_triple(u, v, is_along ? back : -back) &&
         proof.holds_triple(u, v, is_along ? on : -on) &&        //
         proof.holds_cross_products(w, v, u, v) &&               //
         proof.holds_cross_products({v.from, u.to}, v, u, v) &&  //
         proof.holds_cross_products(w, u, u, v) &&               //
         proof.holds_cross_products({v.to, u.from}, u, u, v);
}

}  // namespace graze::narrowphase
