// Akenine-Möller's test in rounded arithmetic. The box axes, and a vertex inside the box, are
// decided by comparing inputs, exactly; the other ten axes by one error bound each kind. Notation
// as in orientation_filter.cpp: u is the unit roundoff, n the smallest double.

#include <graze/narrowphase/triangle_box.h>
#include <algorithm>
#include <cmath>

namespace graze::narrowphase {
namespace {

constexpr double kUnitRoundoff = 0x1p-53;

// With c and h the box's rounded centre and half size, v = vertex - c, f the edges, and V, H, F the
// largest absolute components of v, h, f and M that of the box's minimum and maximum: c is off by
// at most u M, hence v by u (M + V); h by u H; f by u F.
//
// Edge axes: p = f_z v_y - f_y v_z is off by 2 * 3 u F V from its roundings and 2 F u (M + V) from
// v: u F (8 V + 2 M). The radius h_y |f_z| + h_z |f_y| is off by 8 u F H. Comparing them rounds a
// difference of size 2 F (V + H). In all at most 10.1 u F (V + M + H), second order included; the
// rest of 12 pays for the rounding of the bound and for underflow of four products.
constexpr double kEdgeBound = 12 * kUnitRoundoff;

// The normal: n = f_0 x f_1 has components up to 2 F^2, off by 8.1 u F^2. d = n . v is off by
// 3 (8.1 u F^2 V + 2 F^2 u (M + V)) and 18 u F^2 V from its own roundings: u F^2 (48.3 V + 6 M).
// The radius likewise by 48.3 u F^2 H. Comparing rounds a difference of size 6 F^2 (V + H). In all
// at most 55 u F^2 (V + M + H).
constexpr double kNormalBound = 60 * kUnitRoundoff;

// All coordinates at most 2^150: no overflow (F^2 V < 2^453). F and V + M + H at least 2^-250: both
// bounds are above 2^-800, the underflow of products, n / 2 each, times V at most, below 2^-900.
constexpr double kLargestCoordinate = 0x1p+150;
constexpr double kSmallestEdge = 0x1p-250;
constexpr double kSmallestSize = 0x1p-250;

struct CentredTriangle {
  double v[3][3];    // vertices from the box's centre
  double f[3][3];    // edges, f[i] from vertex i to the next
  double half[3];    // of the box
  double largest_f;  // F
  double size;       // V + M + H
  bool is_in_range;  // every input within kLargestCoordinate, hence finite
};

CentredTriangle centred(const Triangle& triangle, const Aabb& box) {
  const double* corner[3] = {triangle.a.data(), triangle.b.data(), triangle.c.data()};
  CentredTriangle result;
  double largest_v = 0, largest_h = 0, largest_m = 0;
  result.largest_f = 0;
  result.is_in_range = true;
  for (int k = 0; k < 3; ++k) {
    const double low = box.min.data()[k];
    const double high = box.max.data()[k];
    const double centre = 0.5 * (low + high);
    result.half[k] = 0.5 * (high - low);
    // Written so that NaN fails.
    result.is_in_range &=
        std::abs(low) <= kLargestCoordinate && std::abs(high) <= kLargestCoordinate && low <= high;
    largest_h = std::max(largest_h, result.half[k]);
    largest_m = std::max(largest_m, std::max(std::abs(low), std::abs(high)));
    for (int i = 0; i < 3; ++i) {
      result.is_in_range &= std::abs(corner[i][k]) <= kLargestCoordinate;
      result.v[i][k] = corner[i][k] - centre;
      result.f[i][k] = corner[(i + 1) % 3][k] - corner[i][k];
      largest_v = std::max(largest_v, std::abs(result.v[i][k]));
      result.largest_f = std::max(result.largest_f, std::abs(result.f[i][k]));
    }
  }
  result.size = largest_v + largest_m + largest_h;
  return result;
}

bool is_apart_along_box_axes(const Triangle& triangle, const Aabb& box) {
  for (int k = 0; k < 3; ++k) {
    const double a = triangle.a.data()[k];
    const double b = triangle.b.data()[k];
    const double c = triangle.c.data()[k];
    if (std::min(std::min(a, b), c) > box.max.data()[k]) return true;
    if (std::max(std::max(a, b), c) < box.min.data()[k]) return true;
  }
  return false;
}

bool contains(const Aabb& box, const Eigen::Vector3d& point) {
  bool is_inside = true;
  for (int k = 0; k < 3; ++k) {
    is_inside &= box.min.data()[k] <= point.data()[k] && point.data()[k] <= box.max.data()[k];
  }
  return is_inside;
}

/// The nine axes e_i x f_j. All vertices are projected: for the two ends of the edge the exact
/// values are equal, the rounded ones may differ within the bound.
Verdict triage_edges(const CentredTriangle& t) {
  const double bound = kEdgeBound * t.largest_f * t.size;
  bool is_sure = true;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    for (int edge = 0; edge < 3; ++edge) {
      const double fj = t.f[edge][j];
      const double fk = t.f[edge][k];
      const int opposite = (edge + 2) % 3;
      const double p = fk * t.v[edge][j] - fj * t.v[edge][k];
      const double q = fk * t.v[opposite][j] - fj * t.v[opposite][k];
      const double radius = t.half[j] * std::abs(fk) + t.half[k] * std::abs(fj);
      const double gap = std::max(std::min(p, q), -std::max(p, q)) - radius;
      if (gap > bound) return Verdict::Apart;
      is_sure &= gap < -bound;
    }
  }
  return is_sure ? Verdict::Touching : Verdict::Unsure;
}

Verdict triage_normal(const CentredTriangle& t) {
  const double bound = kNormalBound * t.largest_f * t.largest_f * t.size;
  const double* e = t.f[0];
  const double* f = t.f[1];
  const double normal[3] = {e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2],
                            e[0] * f[1] - e[1] * f[0]};
  const double distance = normal[0] * t.v[0][0] + normal[1] * t.v[0][1] + normal[2] * t.v[0][2];
  const double radius = t.half[0] * std::abs(normal[0]) + t.half[1] * std::abs(normal[1]) +
                        t.half[2] * std::abs(normal[2]);
  const double gap = std::abs(distance) - radius;
  if (gap > bound) return Verdict::Apart;
  return gap < -bound ? Verdict::Touching : Verdict::Unsure;
}

}  // namespace

Verdict triage(const Triangle& triangle, const Aabb& box) {
  const CentredTriangle t = centred(triangle, box);
  if (!t.is_in_range) return Verdict::Unsure;
  if (is_apart_along_box_axes(triangle, box)) return Verdict::Apart;
  if (contains(box, triangle.a) || contains(box, triangle.b) || contains(box, triangle.c)) {
    return Verdict::Touching;
  }
  if (!(t.largest_f >= kSmallestEdge && t.size >= kSmallestSize)) return Verdict::Unsure;
  const Verdict normal = triage_normal(t);
  if (normal == Verdict::Apart) return Verdict::Apart;
  const Verdict edges = triage_edges(t);
  if (edges == Verdict::Apart) return Verdict::Apart;
  return normal == edges ? normal : Verdict::Unsure;
}

}  // namespace graze::narrowphase
