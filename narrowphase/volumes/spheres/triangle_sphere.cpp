// This file holds the exact stage, and the test as users call it.
//
// The point of the triangle nearest to the centre is a vertex, inside an edge, or inside the face.
// Each is asked for by signs of polynomials in exact differences, with the centre as the origin.
// Which one is nearest need not be known: whatever feature has a point within the radius proves a
// hit, and if there is a hit, the nearest feature proves it. Without area the face is its edges.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/narrowphase/predicates/exact_vector.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/volumes/spheres/triangle_sphere_stages.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>

namespace graze {
namespace narrowphase {
namespace {

struct Centred {
  BigVector corner[3];  ///< the corners as seen from the sphere's centre
  BigVector edge[3];    ///< from corner i to the next
  BigInteger radius2;
};

Centred centred(const Triangle& triangle, const Sphere& sphere) {
  const double* p[3] = {triangle.a.data(), triangle.b.data(), triangle.c.data()};
  CommonUnit unit({sphere.radius});
  unit.include(sphere.centre.data(), 3);
  for (const double* corner : p)
    unit.include(corner, 3);
  Centred result;
  for (int i = 0; i < 3; ++i) {
    result.corner[i] = BigVector::difference(p[i], sphere.centre.data(), unit);
    result.edge[i] = BigVector::difference(p[(i + 1) % 3], p[i], unit);
  }
  result.radius2 = squared(unit.of(sphere.radius));
  return result;
}

bool is_at_most(const BigInteger& a, const BigInteger& b) {
  return (a - b).sign() != Sign::Positive;
}

/// True if a vertex is within the radius, by polynomials of degree two.
bool has_vertex_within(const Centred& t) {
  for (const BigVector& corner : t.corner) {
    if (is_at_most(squared(corner), t.radius2)) return true;
  }
  return false;
}

/// True if the foot of the centre on an edge's line lies between the ends (degree two), and no
/// farther than the radius: |a x f|^2 <= r^2 f^2 (degree four).
bool has_edge_within(const Centred& t) {
  for (int i = 0; i < 3; ++i) {
    const BigVector& a = t.corner[i];
    const BigVector& b = t.corner[(i + 1) % 3];
    const BigVector& f = t.edge[i];
    if (dot(a, f).sign() != Sign::Negative || dot(b, f).sign() != Sign::Positive) continue;
    if (is_at_most(squared(cross(a, f)), t.radius2 * squared(f))) return true;
  }
  return false;
}

/// True if the foot of the centre on the plane lies inside, where its barycentric coordinates (a_i
/// x a_j) . n are not negative (degree four), and no farther than the radius: (a . n)^2 <= r^2 n^2
/// (degree six).
bool has_face_within(const Centred& t) {
  const BigVector normal = cross(t.edge[0], t.edge[1]);
  const BigInteger normal2 = squared(normal);
  if (normal2.sign() == Sign::Zero) return false;
  for (int i = 0; i < 3; ++i) {
    const BigVector area = cross(t.corner[i], t.corner[(i + 1) % 3]);
    if (dot(area, normal).sign() == Sign::Negative) return false;
  }
  return is_at_most(squared(dot(t.corner[0], normal)), t.radius2 * normal2);
}

}  // namespace

bool intersects_exactly(const Triangle& triangle, const Sphere& sphere) {
  check_finite(triangle, "triangle");
  bvh::check_sphere(sphere, "sphere");
  const Centred t = centred(triangle, sphere);
  return has_vertex_within(t) || has_edge_within(t) || has_face_within(t);
}

Decision decide(const Triangle& triangle, const Sphere& sphere) {
  const Verdict verdict = triage(triangle, sphere);
  if (verdict != Verdict::Unsure) return {verdict == Verdict::Yes, Stage::Triage};
  return {intersects_exactly(triangle, sphere), Stage::Exact};
}

}  // namespace narrowphase

bool intersects(const Triangle& triangle, const Sphere& sphere) {
  return bvh::in_standard_arithmetic(
      [&]() -> bool { return narrowphase::decide(triangle, sphere).is_hit; });
}

}  // namespace graze
