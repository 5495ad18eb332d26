#pragma once

// Computes with four points on straight paths in rounded arithmetic, the beginning and the end of a
// stretch of time side by side in two lanes.
//
// With the offsets u, v, w below, all four points are in one plane while (u x v) . w is zero, and
// then, seen along any axis, w = x u + y v or x u - y v for the weights x and y of the places in
// the triangle, or on the two edges, where they might meet: x (u x v) = w x v, and y (u x v) = u x
// w, or w x u.

#include <graze/narrowphase/lanes/two_lanes.h>
#include <graze/narrowphase/motion/paths.h>

#include <limits>

namespace graze::narrowphase {

/// The points themselves: lane 0 at t = 0, lane 1 at t = 1.
struct PathLanes {
  TwoVectors point[4];

  PathLanes(const PointPath& p, const TrianglePath& t)
      : point{lanes_of(p), lanes_of(t.a), lanes_of(t.b), lanes_of(t.c)} {}
  PathLanes(const EdgePath& a, const EdgePath& b)
      : point{lanes_of(a.a), lanes_of(a.b), lanes_of(b.a), lanes_of(b.b)} {}

  /// True if all coordinates are surely finite: their sum is.
  bool are_surely_finite() const {
    TwoLanes sum = both(0);
    for (const TwoVectors& p : point)
      sum += magnitude(p.x) + magnitude(p.y) + magnitude(p.z);
    return sum[0] + sum[1] <= std::numeric_limits<double>::max();
  }

  /// Returns the same points with each axis in a unit of its own, a power of two, so that its
  /// largest coordinate is between 1 and 2: hulls that share a point still do. What underflows is
  /// off by 2^-1075.
  PathLanes in_own_units() const;

 private:
  static TwoVectors lanes_of(const PointPath& path) {
    const double *start = path.start.data(), *end = path.end.data();
    return {TwoLanes{start[0], end[0]}, TwoLanes{start[1], end[1]}, TwoLanes{start[2], end[2]}};
  }
};

/// Holds the offsets u, v and w: b - a, c - a, and the point minus a, for a point and a triangle a,
/// b, c; q - p, s - r and r - p, for edges from p to q and from r to s.
struct OffsetLanes {
  TwoVectors u;
  TwoVectors v;
  TwoVectors w;

  OffsetLanes() = default;
  OffsetLanes(const PathLanes& lanes, PathPair kind) {
    const TwoVectors* p = lanes.point;
    if (kind == PathPair::PointTriangle) {
      u = p[2] - p[1];
      v = p[3] - p[1];
      w = p[0] - p[1];
    } else {
      u = p[1] - p[0];
      v = p[3] - p[2];
      w = p[2] - p[0];
    }
  }
};

inline TwoVectors swapped(const TwoVectors& v) {
  return {swapped(v.x), swapped(v.y), swapped(v.z)};
}

inline TwoVectors operator+(const TwoVectors& a, const TwoVectors& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline TwoLanes in_lane(TwoLanes v, int lane) {
  return both(v[lane]);
}

/// (u x v) . w as a polynomial of degree three in Bernstein's basis, on the stretch between the
/// lanes, its middle coefficients times three.
struct VolumeLanes {
  TwoLanes ends;    ///< the first and the last coefficient
  TwoLanes middle;  ///< three times the coefficients between

  explicit VolumeLanes(const OffsetLanes& o) {
    const TwoVectors normal = cross(o.u, o.v);
    const TwoVectors mixed = cross(o.u, swapped(o.v));  // u_0 x v_1 and u_1 x v_0
    const TwoVectors twice_between = mixed + swapped(mixed);
    ends = dot(normal, o.w);
    middle = dot(normal, swapped(o.w)) + dot(twice_between, o.w);
  }
};

}  // namespace graze::narrowphase
