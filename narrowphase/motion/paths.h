#pragma once

// Four points on straight paths make two sets: a point and a triangle, or two edges.

#include <graze/narrowphase/first_contact.h>

namespace graze::narrowphase {

enum class PathPair {
  PointTriangle,  ///< the first point, and the triangle of the other three
  EdgeEdge        ///< the edge of the first two points, and that of the other two
};

inline PathPair kind_of(const PointPath& /*point*/, const TrianglePath& /*triangle*/) {
  return PathPair::PointTriangle;
}
inline PathPair kind_of(const EdgePath& /*a*/, const EdgePath& /*b*/) {
  return PathPair::EdgeEdge;
}

struct FourPaths {
  PathPair kind;
  const double* start[4];  ///< arrays of three coordinates, one for each point
  const double* end[4];

  FourPaths(const PointPath& point, const TrianglePath& triangle) : kind(PathPair::PointTriangle) {
    set(point, triangle.a, triangle.b, triangle.c);
  }
  FourPaths(const EdgePath& a, const EdgePath& b) : kind(PathPair::EdgeEdge) {
    set(a.a, a.b, b.a, b.b);
  }

 private:
  void set(const PointPath& p, const PointPath& q, const PointPath& r, const PointPath& s) {
    const PointPath* const paths[4] = {&p, &q, &r, &s};
    for (int i = 0; i < 4; ++i) {
      start[i] = paths[i]->start.data();
      end[i] = paths[i]->end.data();
    }
  }
};

}  // namespace graze::narrowphase
