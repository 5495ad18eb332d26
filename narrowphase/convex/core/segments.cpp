#include <graze/narrowphase/convex/core/segments.h>

#include <algorithm>
#include <limits>

namespace graze::narrowphase {
namespace {

// Sizes between which products of four lengths neither overflow nor lose what they are made of.
constexpr double kSmallOfFour = 0x1p-200;
constexpr double kLargeOfFour = 0x1p200;

/// Returns the factor that brings a length to between 1 and 2; 1 for 0.
double unit_scale(double length) {
  return length > 0 ? std::scalbn(1.0, -std::ilogb(length)) : 1;
}

/// Returns the factor that brings the largest coordinate of a vector, not zero, to between 1 and 2.
double to_units_of(const Vec3& a) {
  return unit_scale(largest(a));
}

// Finds where the line from r along a is nearest to that from 0 along b, in lengths of a. The
// offset between them is along c = a x b, so that s c.c = -(r x b).c. Let t be the sine of the
// angle: lines part by t for each unit that s |a| is off. c is off by 3.5 u |a| |b|, which is
// e = 3.5 u / t of itself.
//   Of r, what lies in the plane of a and b makes the numerator s c.c, which is off by e of itself
//   and the square by 2 e: the offset is off by 11 u s |a|, and by 4 u of it that sum and quotient
//   round. The numerator's own rounding, 7.5 u |r| |b| |c|, costs 7.5 u |r|.
//   What stands on the plane, d, makes the numerator 0, but for 3.5 u d |a| |b|^2: the offset is
//   off by 3.5 u d / t, at right angles to d, and longer by half the square of that over d, 6.2 u^2
//   d / t^2. From ends, which are offered as well, it is longer by t^2 l^2 / 2 d, with the length l
//   of the shorter segment: one of these is below 1.8 u l.
// Where t is below 35 u, ends are within 35 u l of the best. By the determinant of squares, whose
// error is u / t^2 of itself, the offset would be off by u / t.
bool find_crossing(const Vec3& a, const Vec3& b, const Vec3& r, double& share) {
  if (!(largest(a) > 0) || !(largest(b) > 0)) return false;
  const double scale = to_units_of(a);
  const Vec3 unit_b = b * to_units_of(b);
  const Vec3 normal = cross(a * scale, unit_b);
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

namespace {

// A triangle is narrow where the square of its height is below this share of that of its length.
// Weights by products of four lengths are off by some u over that share; for triangles that are not
// narrow this is 2^-34, mostly.
constexpr double kNarrow = 0x1p-16;

/// Tells it by the square of the product of two sides, and by their own squares.
bool is_narrow(double of_product, double of_b, double of_c) {
  const double length = std::max(of_b, of_c);
  return !(of_product > kNarrow * (length * length));
}

/// Finds the nearest point inside a narrow triangle, if there is one, by going along the longest
/// edge to the foot, then across it. Nothing there is worse known than corners are.
bool find_inside_narrow(const Vec3* corner, const Vec3& point, Vec3& found) {
  int first = 0;
  double square = -1;
  for (int i = 0; i < 3; ++i) {
    const Vec3 edge = corner[(i + 1) % 3] - corner[i];
    if (dot(edge, edge) > square) first = i, square = dot(edge, edge);
  }
  const Vec3& p = corner[first];
  const Vec3 edge = corner[(first + 1) % 3] - p, beside = corner[(first + 2) % 3] - p;
  const double at = dot(beside, edge) / square, share = dot(point - p, edge) / square;
  const Vec3 across = beside - edge * at;
  const double height = dot(across, across);
  if (!(share > 0 && share < 1) || !(height > 0)) return false;
  const double up = dot((point - p) - edge * share, across) / height;
  if (!(up > 0 && up * at < share && up * (1 - at) < 1 - share)) return false;
  found = p + (edge * share + across * up);
  return true;
}

}  // namespace

Vec3 nearest_on_triangle(const Core& triangle, const Vec3& point) {
  const Vec3* c = triangle.corner;
  const Vec3 edge_b = c[1] - c[0], edge_c = c[2] - c[0];
  // Weights are of degree four: by themselves these would overflow or underflow at lengths that
  // shapes have.
  const double size = std::max(std::max(largest(edge_b), largest(edge_c)), largest(point - c[0]));
  const double scale = size > kSmallOfFour && size < kLargeOfFour ? 1 : unit_scale(size);
  const Vec3 ab = edge_b * scale, ac = edge_c * scale, ap = (point - c[0]) * scale;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  const Vec3 bp = (point - c[1]) * scale, cp = (point - c[2]) * scale;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp), d6 = dot(ac, cp);
  const double of_c = d1 * d4 - d3 * d2, of_b = d5 * d2 - d1 * d6, of_a = d3 * d6 - d5 * d4;
  const double sum = (of_a + of_b) + of_c;
  const bool has_no_plane = is_narrow(sum, dot(ab, ab), dot(ac, ac));
  if (!has_no_plane && of_a > 0 && of_b > 0 && of_c > 0)
    return c[0] + (edge_b * (of_b / sum) + edge_c * (of_c / sum));
  Vec3 best;
  if (has_no_plane && find_inside_narrow(c, point, best)) return best;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vec3 found = nearest_on_segment(c[i], c[(i + 1) % 3], point);
    const double square = dot(found - point, found - point);
    if (square < least) least = square, best = found;
  }
  return best;
}

bool is_narrow(const Core& triangle) {
  const Vec3 edge_b = triangle.corner[1] - triangle.corner[0];
  const Vec3 edge_c = triangle.corner[2] - triangle.corner[0];
  const double scale = unit_scale(std::max(largest(edge_b), largest(edge_c)));
  const Vec3 ab = edge_b * scale, ac = edge_c * scale, product = cross(ab, ac);
  return is_narrow(dot(product, product), dot(ab, ab), dot(ac, ac));
}

}  // namespace graze::narrowphase
