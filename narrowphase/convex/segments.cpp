#include <graze/narrowphase/convex/segments.h>

namespace graze::narrowphase {

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
  const Vec3 r = p_a - p_b;
  const double aa = dot(a, a);
  const double bb = dot(b, b);
  const double ab = dot(a, b);
  const double determinant = aa * bb - ab * ab;
  if (!(determinant > 0)) return best;
  const double share = (ab * dot(b, r) - bb * dot(a, r)) / determinant;
  if (share > 0 && share < 1) {
    const Vec3 on_a = p_a + a * share;
    const Vec3 on_b = nearest_on_segment(p_b, q_b, on_a);
    offer(nearest_on_segment(p_a, q_a, on_b), on_b);
  }
  return best;
}

}  // namespace graze::narrowphase
