// Error bounds. w is kPairRoundoff; U, V, W are the largest components of two edges and of the
// offset between their starts; D is that of all differences and M the largest coordinate, so that
// U, V, W <= D <= 2 M. Law 7 allows each coordinate 4 ulp of M, at least 2^-51 M, and the distance
// 4 ulp of D, at least 2^-51 D. The last rounding of a coordinate takes 2^-53 M, and that of the
// distance, at most sqrt(3) D, 2^-52 D: what remains is more than 2^-52 of M and of D.
//
// Vertex and edge: w.e is off by at most 12 w W V, the ratio by that over e.e >= V^2 and a little,
// the point by less than 40 w W.
//
// Vertex and face: the normal is off by 8 w U V, the height by 50 w U V W. When n.n >= 2^-36 U^2
// V^2, the point, h n / n.n, moves by at most 2^18 * 300 w W < 2^-74 W.
//
// Two edges: each of the parameters' numerators is off by less than 145 w U W V^2 (or with U and V
// exchanged), their determinant by 136 w U^2 V^2. When it is at least 2^-36 U^2 V^2, a point moves
// by less than 2^36 * 150 w (W + U) < 2^-57 (W + U) <= 2^-55 M. The offset between the points moves
// by 2^-55 D in each component: the distance by less than 2^-54 D.

#include <graze/narrowphase/derived/distance_stages.h>
#include <graze/narrowphase/derived/double_pair.h>
#include <graze/narrowphase/derived/simplex.h>
#include <algorithm>

namespace graze::narrowphase {
namespace {

constexpr double kFlattest = 0x1p-36;

// Sizes between these keep products of four, and their error terms, in range: 2^-400 times 2^-107
// is far above what underflow takes, 2^-1074 times 2^300.
constexpr double kSmallest = 0x1p-100;
constexpr double kLargest = 0x1p+100;

using Corners3 = double[3][3];

bool is_in_range(double size) {
  return size >= kSmallest && size <= kLargest;
}

std::array<double, 3> as_array(const double* p) {
  return {p[0], p[1], p[2]};
}

std::array<double, 3> moved(const double* p, const PairVector& by) {
  return {rounded_sum(p[0], by.x), rounded_sum(p[1], by.y), rounded_sum(p[2], by.z)};
}

/// A distance that comes out as zero is left to integers.
std::optional<Witness> witness(const PairVector& offset, const std::array<double, 3>& point_a,
                               const std::array<double, 3>& point_b) {
  if (!is_in_range(largest_component(offset))) return std::nullopt;
  return Witness{rounded_root(dot(offset, offset)), point_a, point_b};
}

std::optional<Witness> between_vertices(const double* p, const double* q) {
  return witness(PairVector::difference(q, p), as_array(p), as_array(q));
}

/// Returns vertex p and its foot on edge e, which is named second.
std::optional<Witness> to_edge(const double* p, const Corners3& y, int edge) {
  const double* start = y[kEdges[edge][0]];
  const PairVector e = PairVector::difference(y[kEdges[edge][1]], start);
  const PairVector w = PairVector::difference(p, start);
  if (!is_in_range(largest_component(e)) || largest_component(w) > kLargest) return std::nullopt;
  const PairVector along = e * (dot(w, e) / dot(e, e));
  return witness(along - w, as_array(p), moved(start, along));
}

std::optional<Witness> to_face(const double* p, const Corners3& y) {
  const PairVector e = PairVector::difference(y[1], y[0]);
  const PairVector f = PairVector::difference(y[2], y[0]);
  const PairVector w = PairVector::difference(p, y[0]);
  const double size_e = largest_component(e);
  const double size_f = largest_component(f);
  if (!is_in_range(size_e) || !is_in_range(size_f) || largest_component(w) > kLargest) {
    return std::nullopt;
  }
  const PairVector normal = cross(e, f);
  const DoublePair square = dot(normal, normal);
  const double size = size_e * size_f;
  if (!(square.high >= kFlattest * (size * size))) return std::nullopt;
  const PairVector down = normal * -(dot(w, normal) / square);
  return witness(down, as_array(p), moved(p, down));
}

std::optional<Witness> between_edges(const OrderedTriangles& t, int edge_a, int edge_b) {
  const double* start_a = t.a[kEdges[edge_a][0]];
  const double* start_b = t.b[kEdges[edge_b][0]];
  const PairVector u = PairVector::difference(t.a[kEdges[edge_a][1]], start_a);
  const PairVector v = PairVector::difference(t.b[kEdges[edge_b][1]], start_b);
  const PairVector w = PairVector::difference(start_b, start_a);
  const double size_u = largest_component(u);
  const double size_v = largest_component(v);
  if (!is_in_range(size_u) || !is_in_range(size_v) || largest_component(w) > kLargest) {
    return std::nullopt;
  }
  const DoublePair uu = dot(u, u), uv = dot(u, v), vv = dot(v, v);
  const DoublePair uw = dot(u, w), vw = dot(v, w);
  const DoublePair determinant = uu * vv - uv * uv;
  const double size = size_u * size_v;
  if (!(determinant.high >= kFlattest * (size * size))) return std::nullopt;
  const PairVector along_u = u * ((uw * vv - vw * uv) / determinant);
  const PairVector along_v = v * ((uw * uv - vw * uu) / determinant);
  return witness(w + along_v - along_u, moved(start_a, along_u), moved(start_b, along_v));
}

std::optional<Witness> mirrored(std::optional<Witness> found) {
  if (found) std::swap(found->point_a, found->point_b);
  return found;
}

}  // namespace

std::optional<Witness> rounded_witness(const OrderedTriangles& t, const FeaturePair& pair) {
  const double* vertex_a = t.a[pair.index_a];
  const double* vertex_b = t.b[pair.index_b];
  if (pair.kind_a == Feature::Face) return mirrored(to_face(vertex_b, t.a));
  if (pair.kind_b == Feature::Face) return to_face(vertex_a, t.b);
  if (pair.kind_a == Feature::Vertex) {
    if (pair.kind_b == Feature::Vertex) return between_vertices(vertex_a, vertex_b);
    return to_edge(vertex_a, t.b, pair.index_b);
  }
  if (pair.kind_b == Feature::Vertex) return mirrored(to_edge(vertex_b, t.a, pair.index_a));
  return between_edges(t, pair.index_a, pair.index_b);
}

}  // namespace graze::narrowphase
