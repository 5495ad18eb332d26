#include <graze/narrowphase/convex/gap/nearest_on_simplex.h>

#include <limits>

namespace graze::narrowphase {
namespace {

/// Holds the best face so far: which points with which weights.
struct Best {
  double square = std::numeric_limits<double>::infinity();
  Vec3 nearest;
  Vec3 direction;
  int index[3];
  double weight[3];
  int count = 0;
};

void offer(Best& best, const Vec3& nearest, int count, const int (&index)[3],
           const double (&weight)[3]) {
  const double square = dot(nearest, nearest);
  if (!(square < best.square)) return;
  best.square = square;
  best.nearest = nearest;
  best.direction = nearest;
  best.count = count;
  for (int i = 0; i < count; ++i) {
    best.index[i] = index[i];
    best.weight[i] = weight[i];
  }
}

void offer_vertex(Best& best, const DifferenceSimplex& s, int i) {
  offer(best, s.point[i], 1, {i, 0, 0}, {1, 0, 0});
}

/// Offers an edge only if the nearest point lies between its ends.
void offer_edge(Best& best, const DifferenceSimplex& s, int i, int j) {
  const Vec3 edge = s.point[j] - s.point[i];
  const double square = dot(edge, edge);
  const double along = -dot(s.point[i], edge);
  if (!(along > 0) || !(along < square)) return;
  const double share = along / square;
  offer(best, s.point[i] + edge * share, 2, {i, j, 0}, {1 - share, share, 0});
}

/// Offers a face only if the origin projects into it.
void offer_face(Best& best, const DifferenceSimplex& s, int i, int j, int k) {
  const Vec3& a = s.point[i];
  const Vec3& b = s.point[j];
  const Vec3& c = s.point[k];
  const Vec3 normal = cross(b - a, c - a);
  const double square = dot(normal, normal);
  if (!(square > 0)) return;
  // Weights are found by edges: of points that are close, these are known far better than the
  // points' products.
  const double u = dot(normal, cross(b, c - b));
  const double v = dot(normal, cross(c, a - c));
  const double w = dot(normal, cross(a, b - a));
  if (u < 0 || v < 0 || w < 0) return;
  const double sum = u + v + w;
  if (!(sum > 0)) return;
  const Vec3 nearest = (a * (u / sum) + b * (v / sum)) + c * (w / sum);
  const int before = best.count;
  const double least = best.square;
  offer(best, nearest, 3, {i, j, k}, {u / sum, v / sum, w / sum});
  if (best.count == before && best.square == least) return;
  const double height = dot(normal, nearest);
  best.direction = height < 0 ? -normal : normal;
}

void offer_triangle(Best& best, const DifferenceSimplex& s, int i, int j, int k) {
  offer_edge(best, s, i, j);
  offer_edge(best, s, i, k);
  offer_edge(best, s, j, k);
  offer_face(best, s, i, j, k);
}

/// True if the origin lies on the inner side of all four faces. A tetrahedron whose volume could be
/// rounding alone holds nothing: products of edges of length l are off by some 16 u l^3.
bool holds_origin(DifferenceSimplex& s) {
  const Vec3& d = s.point[3];
  const Vec3 a = s.point[0] - d;
  const Vec3 b = s.point[1] - d;
  const Vec3 c = s.point[2] - d;
  const double volume = dot(a, cross(b, c));
  const double size = largest(a) + largest(b) + largest(c);
  if (!(std::abs(volume) > 0x1p-48 * (size * size * size))) return false;
  const double side = volume < 0 ? -1 : 1;
  // The origin is -d from d: its volumes with three faces by Cramer's rule, the fourth by the rest.
  const Vec3 o = -d;
  const double with_a = side * dot(o, cross(b, c));
  const double with_b = side * dot(a, cross(o, c));
  const double with_c = side * dot(a, cross(b, o));
  const double with_d = side * volume - (with_a + with_b + with_c);
  if (with_a < 0 || with_b < 0 || with_c < 0 || with_d < 0) return false;
  const double whole = side * volume;
  s.weight[0] = with_a / whole;
  s.weight[1] = with_b / whole;
  s.weight[2] = with_c / whole;
  s.weight[3] = with_d / whole;
  // A flat tetrahedron's weights are known badly. The point to which they lead tells whether well
  // enough: it has to be nearer to the origin than what counts as touching, 2^-34 of the scale, of
  // which the size is six times at most.
  const Vec3 led_to = ((s.point[0] * s.weight[0] + s.point[1] * s.weight[1]) +
                       (s.point[2] * s.weight[2] + s.point[3] * s.weight[3]));
  return largest(led_to) <= 0x1p-38 * size;
}

}  // namespace

OriginSide reduce_to_nearest(DifferenceSimplex& simplex, NearestPoint& nearest) {
  const int n = simplex.count;
  if (n == 4 && holds_origin(simplex)) {
    nearest = {};
    return OriginSide::Inside;
  }
  Best best;
  for (int i = 0; i < n; ++i)
    offer_vertex(best, simplex, i);
  if (n == 2) offer_edge(best, simplex, 0, 1);
  if (n == 3) offer_triangle(best, simplex, 0, 1, 2);
  if (n == 4) {
    // Each edge is offered once, and each face once.
    offer_triangle(best, simplex, 0, 1, 2);
    offer_edge(best, simplex, 0, 3);
    offer_edge(best, simplex, 1, 3);
    offer_edge(best, simplex, 2, 3);
    offer_face(best, simplex, 0, 1, 3);
    offer_face(best, simplex, 0, 2, 3);
    offer_face(best, simplex, 1, 2, 3);
  }
  // Indices ascend, so that points move down in place.
  for (int i = 0; i < best.count; ++i) {
    const int from = best.index[i];
    simplex.point[i] = simplex.point[from];
    simplex.from_a[i] = simplex.from_a[from];
    simplex.from_b[i] = simplex.from_b[from];
    simplex.weight[i] = best.weight[i];
  }
  simplex.count = best.count;
  nearest = {best.nearest, best.direction};
  return OriginSide::Outside;
}

}  // namespace graze::narrowphase
