#include <graze/narrowphase/derived/distance_stages.h>
#include <graze/narrowphase/derived/double_pair.h>
#include <graze/narrowphase/derived/simplex.h>
#include <graze/narrowphase/predicates/exact_vector.h>
#include <algorithm>
#include <limits>

namespace graze::narrowphase {
namespace {

using Corners3 = double[3][3];

/// Rounds what the features below compute, in the unit of the coordinates.
class Rounding {
 public:
  explicit Rounding(const OrderedTriangles& t) : unit_({}) {
    unit_.include(&t.a[0][0], 9);
    unit_.include(&t.b[0][0], 9);
  }

  BigVector minus(const double* a, const double* b) const {
    return BigVector::difference(a, b, unit_);
  }

  /// Returns base + vector * numerator / denominator.
  std::array<double, 3> point(const double* base, const BigVector& vector,
                              const BigInteger& numerator, const BigInteger& denominator) const {
    const BigInteger* component[3] = {&vector.x, &vector.y, &vector.z};
    std::array<double, 3> rounded;
    for (int k = 0; k < 3; ++k) {
      const BigInteger sum = unit_.of(base[k]) * denominator + *component[k] * numerator;
      rounded[k] = rounded_ratio(sum, denominator, unit_.exponent());
    }
    return rounded;
  }

  /// Returns the root of square / denominator, which is not 0 even where it rounds to 0.
  double distance(const BigInteger& square, const BigInteger& denominator) const {
    return std::max(rounded_root_of_ratio(square, denominator, unit_.exponent()),
                    std::numeric_limits<double>::denorm_min());
  }

 private:
  CommonUnit unit_;
};

std::array<double, 3> as_array(const double* p) {
  return {p[0], p[1], p[2]};
}

Witness between_vertices(const Rounding& rounding, const double* p, const double* q) {
  const BigInteger one = BigInteger::from_double(1, 0);
  return {rounding.distance(squared(rounding.minus(q, p)), one), as_array(p), as_array(q)};
}

/// The foot is at (w.e) / (e.e) along the edge, and the distance is |w x e| / |e|.
Witness to_edge(const Rounding& rounding, const double* p, const Corners3& y, int edge) {
  const double* start = y[kEdges[edge][0]];
  const BigVector e = rounding.minus(y[kEdges[edge][1]], start);
  const BigVector w = rounding.minus(p, start);
  const BigInteger ee = squared(e);
  return {rounding.distance(squared(cross(w, e)), ee), as_array(p),
          rounding.point(start, e, dot(w, e), ee)};
}

/// With the height h = w.n, the distance is |h| / |n|, and the foot p - n h / (n.n).
Witness to_face(const Rounding& rounding, const double* p, const Corners3& y) {
  const BigVector n = cross(rounding.minus(y[1], y[0]), rounding.minus(y[2], y[0]));
  const BigInteger down = dot(rounding.minus(y[0], p), n);
  const BigInteger nn = squared(n);
  return {rounding.distance(squared(down), nn), as_array(p), rounding.point(p, n, down, nn)};
}

/// The nearest points are as in optimality.h; the distance is |w.n| / |n|.
Witness between_edges(const Rounding& rounding, const OrderedTriangles& t, int edge_a, int edge_b) {
  const double* start_a = t.a[kEdges[edge_a][0]];
  const double* start_b = t.b[kEdges[edge_b][0]];
  const BigVector u = rounding.minus(t.a[kEdges[edge_a][1]], start_a);
  const BigVector v = rounding.minus(t.b[kEdges[edge_b][1]], start_b);
  const BigVector w = rounding.minus(start_b, start_a);
  const BigVector n = cross(u, v);
  const BigInteger nn = squared(n);
  return {rounding.distance(squared(dot(w, n)), nn),
          rounding.point(start_a, u, dot(cross(w, v), n), nn),
          rounding.point(start_b, v, dot(cross(w, u), n), nn)};
}

Witness mirrored(const Witness& found) {
  return {found.distance, found.point_b, found.point_a};
}

}  // namespace

Witness exact_witness(const OrderedTriangles& t, const FeaturePair& pair) {
  const Rounding rounding(t);
  const double* vertex_a = t.a[pair.index_a];
  const double* vertex_b = t.b[pair.index_b];
  if (pair.kind_a == Feature::Face) return mirrored(to_face(rounding, vertex_b, t.a));
  if (pair.kind_b == Feature::Face) return to_face(rounding, vertex_a, t.b);
  if (pair.kind_a == Feature::Vertex) {
    if (pair.kind_b == Feature::Vertex) return between_vertices(rounding, vertex_a, vertex_b);
    return to_edge(rounding, vertex_a, t.b, pair.index_b);
  }
  if (pair.kind_b == Feature::Vertex) {
    return mirrored(to_edge(rounding, vertex_b, t.a, pair.index_a));
  }
  return between_edges(rounding, t, pair.index_a, pair.index_b);
}

}  // namespace graze::narrowphase
