// Guigue and Devillers' test in rounded arithmetic, with one error bound for the three determinants
// of each plane. Notation as in orientation_filter.cpp: u is the unit roundoff, n the smallest
// double.

#include <graze/narrowphase/lone_vertex.h>
#include <graze/narrowphase/orientation_stages.h>
#include <graze/narrowphase/plane_bound.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <algorithm>
#include <cmath>

namespace graze::narrowphase {
namespace {

struct Vector {
  double x, y, z;
};

Vector difference(const double* a, const double* b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vector largest_components(const Vector& a, const Vector& b) {
  return {std::max(std::abs(a.x), std::abs(b.x)), std::max(std::abs(a.y), std::abs(b.y)),
          std::max(std::abs(a.z), std::abs(b.z))};
}

/// On which sides of the plane of one triangle the vertices of the other lie. Zero means unsure.
struct Sides {
  Sign sign[3];

  bool are_sure() const {
    return sign[0] != Sign::Zero && sign[1] != Sign::Zero && sign[2] != Sign::Zero;
  }
  bool are_equal() const { return sign[0] == sign[1] && sign[1] == sign[2]; }
};

/// The shared sub-determinants of a plane are the components of its normal. A coordinate that is
/// not finite makes all determinants that it enters infinite or NaN, and a bound that is not
/// finite, or a comparison with NaN, is never passed: Zero.
Sides sides_of_plane(const Triangle& plane, const Triangle& other) {
  const double* origin = plane.a.data();
  const Vector edge_b = difference(plane.b.data(), origin);
  const Vector edge_c = difference(plane.c.data(), origin);
  const Vector normal = cross(edge_b, edge_c);
  const Vector way[3] = {difference(other.a.data(), origin), difference(other.b.data(), origin),
                         difference(other.c.data(), origin)};
  const Vector e = largest_components(edge_b, edge_c);
  const Vector d = largest_components(way[0], largest_components(way[1], way[2]));
  const double size = e.y * e.z * d.x + e.z * e.x * d.y + e.x * e.y * d.z;
  const double largest =
      std::max(std::max(std::max(e.x, e.y), e.z), std::max(std::max(d.x, d.y), d.z));
  Sides sides{};
  if (!(size >= kSmallestPlaneSize && largest <= kLargestDifference)) return sides;
  const double bound = kPlaneBound * size;
  for (int i = 0; i < 3; ++i) {
    const double determinant = dot(normal, way[i]);
    sides.sign[i] = determinant > bound    ? Sign::Positive
                    : determinant < -bound ? Sign::Negative
                                           : Sign::Zero;
  }
  return sides;
}

/// A triangle seen from its lone vertex, in an order in which the other's lone vertex is on the
/// positive side of its plane.
struct Canonical {
  const double* p;
  const double* q;
  const double* r;
};

Canonical canonical(const Triangle& triangle, int lone, Sign other_side) {
  const double* corner[3] = {triangle.a.data(), triangle.b.data(), triangle.c.data()};
  const double* q = corner[(lone + 1) % 3];
  const double* r = corner[(lone + 2) % 3];
  if (other_side == Sign::Negative) std::swap(q, r);
  return {corner[lone], q, r};
}

}  // namespace

Verdict triage(const Triangle& triangle_a, const Triangle& triangle_b) {
  const Sides a = sides_of_plane(triangle_b, triangle_a);
  if (a.are_sure() && a.are_equal()) return Verdict::Apart;
  const Sides b = sides_of_plane(triangle_a, triangle_b);
  if (b.are_sure() && b.are_equal()) return Verdict::Apart;
  if (!a.are_sure() || !b.are_sure()) return Verdict::Unsure;

  const LoneVertex lone_a = find_lone_vertex(a.sign);
  const LoneVertex lone_b = find_lone_vertex(b.sign);
  const Canonical s = canonical(triangle_a, lone_a.index, lone_b.side);
  const Canonical t = canonical(triangle_b, lone_b.index, lone_a.side);
  // Figure 5 of the paper: the intervals that both cut out of the common line overlap unless one
  // ends before the other begins.
  const auto first = orientation_3d_filter(s.p, s.q, t.p, t.q);
  const auto second = orientation_3d_filter(s.p, s.r, t.r, t.p);
  if (first == Sign::Positive || second == Sign::Positive) return Verdict::Apart;
  if (first && second) return Verdict::Touching;
  return Verdict::Unsure;
}

}  // namespace graze::narrowphase
