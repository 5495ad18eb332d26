// The nearest points of two triangles lie on two edges, or one is a vertex and the other inside the
// face: nine pairs of segments and six vertices with a face, in plain double. Ericson, "Real-Time
// Collision Detection", 2005, 5.1.9 and 5.1.10. Nothing here needs a bound: find_surely_nearest()
// asks for a proof.

#include <graze/narrowphase/derived/nearest_features.h>
#include <graze/narrowphase/derived/simplex.h>
#include <algorithm>
#include <limits>

namespace graze::narrowphase {
namespace {

struct Vector {
  double x, y, z;
};

Vector difference(const double* a, const double* b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double clamped(double s) {
  return s > 0 ? (s < 1 ? s : 1) : 0;  // NaN, of an edge without length, becomes 0
}

/// The feature of an edge at parameter s: one of its ends, or its inside.
void set_feature(Feature& kind, int& index, int edge, double s) {
  kind = s > 0 && s < 1 ? Feature::Edge : Feature::Vertex;
  index = kind == Feature::Edge ? edge : kEdges[edge][s > 0];
}

struct Guess {
  double squared = std::numeric_limits<double>::infinity();
  FeaturePair pair{Feature::Vertex, 0, Feature::Vertex, 0};
};

struct Parameters {
  double s;
  double t;
};

/// Where |w + t v - s u| is least, s and t from 0 to 1.
Parameters nearest_on_edges(double uu, double uv, double vv, double uw, double vw) {
  const double determinant = uu * vv - uv * uv;
  double s = clamped((uw * vv - vw * uv) / determinant);
  double t = (s * uv - vw) / vv;
  if (!(t > 0)) {
    t = 0;
    s = clamped(uw / uu);
  } else if (t > 1) {
    t = 1;
    s = clamped((uw + uv) / uu);
  }
  return {s, t};
}

void try_edges(const OrderedTriangles& t, Guess& best) {
  Vector u[3], v[3];
  double uu[3], vv[3];
  for (int i = 0; i < 3; ++i) {
    u[i] = difference(t.a[kEdges[i][1]], t.a[kEdges[i][0]]);
    v[i] = difference(t.b[kEdges[i][1]], t.b[kEdges[i][0]]);
    uu[i] = dot(u[i], u[i]);
    vv[i] = dot(v[i], v[i]);
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vector w = difference(t.b[kEdges[j][0]], t.a[kEdges[i][0]]);
      const Parameters at =
          nearest_on_edges(uu[i], dot(u[i], v[j]), vv[j], dot(u[i], w), dot(v[j], w));
      const Vector way{w.x + at.t * v[j].x - at.s * u[i].x, w.y + at.t * v[j].y - at.s * u[i].y,
                       w.z + at.t * v[j].z - at.s * u[i].z};
      const double squared = dot(way, way);
      if (!(squared < best.squared)) continue;
      best.squared = squared;
      set_feature(best.pair.kind_a, best.pair.index_a, i, at.s);
      set_feature(best.pair.kind_b, best.pair.index_b, j, at.t);
    }
  }
}

/// The vertex of x that is nearest to the plane of y, if all are on one side of it and it is above
/// the inside of y: its number, else -1.
int try_face(const double (&x)[3][3], const double (&y)[3][3]) {
  const Vector normal = cross(difference(y[1], y[0]), difference(y[2], y[0]));
  double height[3];
  for (int i = 0; i < 3; ++i)
    height[i] = dot(normal, difference(x[i], y[0]));
  const bool is_above = height[0] > 0 && height[1] > 0 && height[2] > 0;
  const bool is_below = height[0] < 0 && height[1] < 0 && height[2] < 0;
  if (!is_above && !is_below) return -1;
  if (is_below) {
    for (double& h : height)
      h = -h;
  }
  const int nearest = static_cast<int>(std::min_element(height, height + 3) - height);
  for (int k = 0; k < 3; ++k) {
    const Vector edge = difference(y[(k + 1) % 3], y[k]);
    if (!(dot(cross(edge, difference(x[nearest], y[k])), normal) > 0)) return -1;
  }
  return nearest;
}

}  // namespace

FeaturePair guess_nearest(const OrderedTriangles& triangles) {
  Guess best;
  const int vertex_a = try_face(triangles.a, triangles.b);
  if (vertex_a >= 0) return {Feature::Vertex, vertex_a, Feature::Face, 0};
  const int vertex_b = try_face(triangles.b, triangles.a);
  if (vertex_b >= 0) return {Feature::Face, 0, Feature::Vertex, vertex_b};
  try_edges(triangles, best);
  return best.pair;
}

}  // namespace graze::narrowphase
