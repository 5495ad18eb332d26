#include <graze/narrowphase/convex/segments.h>
#include <graze/narrowphase/expansion.h>

namespace graze::narrowphase {
namespace {

/// a b - c d: rounded once, and by 2 u^2 of both products.
double difference_of_products(double a, double b, double c, double d) {
  const RoundedPair first = two_product(a, b);
  const RoundedPair second = two_product(c, d);
  return (first.value - second.value) + (first.error - second.error);
}

Vec3 accurate_cross(const Vec3& a, const Vec3& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

/// What brings the largest coordinate of a vector, not zero, to between 1 and 2.
double to_units_of(const Vec3& a) {
  return std::scalbn(1.0, -std::ilogb(largest(a)));
}

// Where the line from 0 along a is nearest to that from r' along b, in lengths of a: with c = a x
// b, the way between them is along c, so that s c.c = -(r x b).c, r = -r'. Lines at an angle t part
// by t for each unit that s a is off. The sizes of r, b and c bound the numerator's terms, so that
// s |a|, divided by |c| = |a| |b| t, is off by 11 u |r| / t and the way by 11 u |r|, if c is known
// to some u of itself. Rounded as products are, it would be known to 2 u |a| |b|, and the way to 2
// u / t. Here it is known to 2 u of itself and 4 u^2 |a| |b|, so that s is off by 12 u of itself,
// for t above 4 u. Below, ends do as well: lines are 4 u from parallel.
bool find_crossing(const Vec3& a, const Vec3& b, const Vec3& r, double& share) {
  if (!(largest(a) > 0) || !(largest(b) > 0)) return false;
  const double scale = to_units_of(a);
  const Vec3 unit_b = b * to_units_of(b);
  const Vec3 normal = accurate_cross(a * scale, unit_b);
  const double square = dot(normal, normal);
  if (!(square > 0)) return false;
  share = -dot(cross(r * scale, unit_b), normal) / square;
  return share > 0 && share < 1;
}

}  // namespace

Vec3 nearest_on_segment(const Vec3& p, const Vec3& q, const Vec3& point) {
  const Vec3 edge = q - p;
  const double square = dot(edge, edge);
  const double along = dot(point - p, edge);
  if (!(along > 0) || !(square > 0)) return p;
  if (along >= square) return q;
  return p + edge * (along / square);
}

NearestPoints nearest_of_segments(const Vec3& p_a, const Vec3& q_a, const Vec3& p_b,
                                  const Vec3& q_b) {
  NearestPoints best{p_a, nearest_on_segment(p_b, q_b, p_a)};
  double least = dot(best.point_a - best.point_b, best.point_a - best.point_b);
  const auto offer = [&](const Vec3& on_a, const Vec3& on_b) {
    const double square = dot(on_a - on_b, on_a - on_b);
    if (square < least) least = square, best = {on_a, on_b};
  };
  offer(q_a, nearest_on_segment(p_b, q_b, q_a));
  offer(nearest_on_segment(p_a, q_a, p_b), p_b);
  offer(nearest_on_segment(p_a, q_a, q_b), q_b);

  const Vec3 a = q_a - p_a;
  const Vec3 b = q_b - p_b;
  double share;
  if (find_crossing(a, b, p_a - p_b, share)) {
    const Vec3 on_a = p_a + a * share;
    const Vec3 on_b = nearest_on_segment(p_b, q_b, on_a);
    offer(nearest_on_segment(p_a, q_a, on_b), on_b);
  }
  return best;
}

}  // namespace graze::narrowphase
