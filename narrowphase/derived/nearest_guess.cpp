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
  const double above = s > 0 ? s : 0;  // NaN, of an edge without length, becomes 0
  return above < 1 ? above : 1;
}

/// Sets the feature of an edge at parameter s: one of its ends, or its inside.
void set_feature(Feature& kind, int& index, int edge, double s) {
  kind = s > 0 && s < 1 ? Feature::Edge : Feature::Vertex;
  index = kind == Feature::Edge ? edge : kEdges[edge][s > 0];
}

/// Holds the edges of a triangle, component by component: loops over four of them, the last one
/// twice, become vectors.
struct Edges {
  explicit Edges(const double (&corners)[3][3]) {
    for (int i = 0; i < 4; ++i) {
      const double* start = corners[kEdges[std::min(i, 2)][0]];
      const Vector edge = difference(corners[kEdges[std::min(i, 2)][1]], start);
      for (int k = 0; k < 3; ++k)
        from[k][i] = start[k];
      along[0][i] = edge.x;
      along[1][i] = edge.y;
      along[2][i] = edge.z;
      square[i] = dot(edge, edge);
      inverse[i] = 1 / square[i];
    }
  }

  double from[3][4];
  double along[3][4];
  double square[4];
  double inverse[4];
};

/// Holds the nearest points of edge i of A and each edge of B: |w + t v - s u| is least for s and t
/// from 0 to 1.
struct Nearest {
  double squared[4];
  double s[4];
  double t[4];
};

Nearest nearest_on_edges(const Edges& a, int i, const Edges& b) {
  const double ux = a.along[0][i], uy = a.along[1][i], uz = a.along[2][i];
  const double uu = a.square[i];
  Nearest result;
  for (int j = 0; j < 4; ++j) {
    const double vx = b.along[0][j], vy = b.along[1][j], vz = b.along[2][j];
    const double wx = b.from[0][j] - a.from[0][i];
    const double wy = b.from[1][j] - a.from[1][i];
    const double wz = b.from[2][j] - a.from[2][i];
    const double uv = ux * vx + uy * vy + uz * vz;
    const double uw = ux * wx + uy * wy + uz * wz;
    const double vw = vx * wx + vy * wy + vz * wz;
    const double on_lines = clamped((uw * b.square[j] - vw * uv) / (uu * b.square[j] - uv * uv));
    const double t = clamped((on_lines * uv - vw) * b.inverse[j]);
    const double s = clamped((t * uv + uw) * a.inverse[i]);
    const double x = wx + t * vx - s * ux;
    const double y = wy + t * vy - s * uy;
    const double z = wz + t * vz - s * uz;
    result.s[j] = s;
    result.t[j] = t;
    result.squared[j] = x * x + y * y + z * z;
  }
  return result;
}

FeaturePair try_edges(const OrderedTriangles& triangles) {
  const Edges a(triangles.a);
  const Edges b(triangles.b);
  FeaturePair best{Feature::Vertex, 0, Feature::Vertex, 0};
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Nearest found = nearest_on_edges(a, i, b);
    for (int j = 0; j < 3; ++j) {
      if (!(found.squared[j] < least)) continue;
      least = found.squared[j];
      set_feature(best.kind_a, best.index_a, i, found.s[j]);
      set_feature(best.kind_b, best.index_b, j, found.t[j]);
    }
  }
  return best;
}

/// Returns the number of the vertex of x that is nearest to the plane of y, if all are on one side
/// of it and it is above the inside of y, and else -1.
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
  const int vertex_a = try_face(triangles.a, triangles.b);
  if (vertex_a >= 0) return {Feature::Vertex, vertex_a, Feature::Face, 0};
  const int vertex_b = try_face(triangles.b, triangles.a);
  if (vertex_b >= 0) return {Feature::Face, 0, Feature::Vertex, vertex_b};
  return try_edges(triangles);
}

}  // namespace graze::narrowphase
