#include <algorithm>
#include <cmath>

#include "tests/narrowphase/derived/rational_triangles.h"

namespace graze::oracle {
namespace {

using Point = RationalPoint;
using Polygon = std::vector<Point>;

Point minus(const Point& p, const Point& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

Point moved(const Point& p, const Point& d, const mpq_class& t) {
  return {p[0] + t * d[0], p[1] + t * d[1], p[2] + t * d[2]};
}

Point cross(const Point& p, const Point& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

mpq_class dot(const Point& p, const Point& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

Polygon corners(const Triangle& t) {
  return {exactly(t.a), exactly(t.b), exactly(t.c)};
}

struct HalfSpace {  // the points with normal . x <= offset
  Point normal;
  mpq_class offset;
};

void add_below(std::vector<HalfSpace>& spaces, const Point& normal, const Point& through) {
  spaces.push_back({normal, dot(normal, through)});
}

void add_at(std::vector<HalfSpace>& spaces, const Point& normal, const Point& through) {
  add_below(spaces, normal, through);
  add_below(spaces, {-normal[0], -normal[1], -normal[2]}, through);
}

/// The triangle, segment or point as an intersection of half-spaces.
std::vector<HalfSpace> half_spaces(const Triangle& triangle) {
  const Polygon t = corners(triangle);
  const Point normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  std::vector<HalfSpace> spaces;
  if (normal != Point{}) {
    add_at(spaces, normal, t[0]);
    for (int i = 0; i < 3; ++i)
      add_below(spaces, cross(minus(t[(i + 1) % 3], t[i]), normal), t[i]);
    return spaces;
  }
  const auto [low, high] = std::minmax_element(t.begin(), t.end());
  const Point along = minus(*high, *low);
  for (int axis = 0; axis < 3; ++axis) {
    Point unit;
    unit[axis] = 1;
    add_at(spaces, along == Point{} ? unit : cross(along, unit), *low);
  }
  add_below(spaces, along, *high);
  add_below(spaces, {-along[0], -along[1], -along[2]}, *low);
  return spaces;
}

// Sutherland and Hodgman.
Polygon clip(const Polygon& polygon, const HalfSpace& space) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& p = polygon[i];
    const Point& q = polygon[(i + 1) % polygon.size()];
    const mpq_class over_p = dot(space.normal, p) - space.offset;
    const mpq_class over_q = dot(space.normal, q) - space.offset;
    if (over_p <= 0) result.push_back(p);
    if (sgn(over_p) * sgn(over_q) < 0) {
      result.push_back(moved(p, minus(q, p), over_p / (over_p - over_q)));
    }
  }
  return result;
}

bool is_between(const Point& p, const Point& previous, const Point& next) {
  const Point to = minus(p, previous);
  const Point from = minus(next, p);
  return cross(to, from) == Point{} && dot(to, from) >= 0;
}

/// Without the corners that repeat or lie between others.
Polygon simplified(Polygon polygon) {
  for (std::size_t i = 0; i < polygon.size() && polygon.size() > 1;) {
    const std::size_t n = polygon.size();
    if (is_between(polygon[i], polygon[(i + n - 1) % n], polygon[(i + 1) % n])) {
      polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;
    } else {
      ++i;
    }
  }
  return polygon;
}

mpq_class clamped(const mpq_class& s) {
  return s < 0 ? mpq_class(0) : s > 1 ? mpq_class(1) : s;
}

Point nearest_on_segment(const Point& p, const Point& from, const Point& to) {
  const Point d = minus(to, from);
  const mpq_class square = dot(d, d);
  return square == 0 ? from : moved(from, d, clamped(dot(minus(p, from), d) / square));
}

/// Ericson, "Real-Time Collision Detection", 5.1.9.
RationalPair nearest_on_segments(const Point& p0, const Point& p1, const Point& q0,
                                 const Point& q1) {
  const Point d = minus(p1, p0), e = minus(q1, q0), r = minus(p0, q0);
  const mpq_class a = dot(d, d), b = dot(d, e), c = dot(d, r), g = dot(e, e);
  const mpq_class denominator = a * g - b * b;
  Point p = denominator == 0 ? p0 : moved(p0, d, clamped((b * dot(e, r) - c * g) / denominator));
  const Point q = nearest_on_segment(p, q0, q1);
  p = nearest_on_segment(q, p0, p1);
  return {p, nearest_on_segment(p, q0, q1)};
}

Point nearest_on_triangle(const Point& p, const Polygon& t) {
  const Point normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
  if (normal != Point{}) {
    const Point foot = moved(p, normal, dot(minus(t[0], p), normal) / dot(normal, normal));
    bool is_inside = true;
    for (int i = 0; i < 3; ++i) {
      is_inside &= dot(cross(minus(t[(i + 1) % 3], t[i]), minus(foot, t[i])), normal) >= 0;
    }
    if (is_inside) return foot;
  }
  Point best;
  mpq_class least = -1;
  for (int i = 0; i < 3; ++i) {
    const Point q = nearest_on_segment(p, t[i], t[(i + 1) % 3]);
    const mpq_class square = squared_distance(p, q);
    if (least >= 0 && square >= least) continue;
    least = square;
    best = q;
  }
  return best;
}

void consider(RationalDistance& result, const RationalPair& pair) {
  const mpq_class square = squared_distance(pair.a, pair.b);
  if (!result.nearest.empty() && square > result.square) return;
  if (result.nearest.empty() || square < result.square) result.nearest.clear();
  result.square = square;
  const auto& known = result.nearest;
  if (std::find(known.begin(), known.end(), pair) == known.end()) result.nearest.push_back(pair);
}

mpq_class ulp(const mpq_class& value) {
  // A difference of doubles can be twice the largest double.
  const int exponent = std::min(std::max(std::ilogb(value.get_d()), -1022), 1024) - 52;
  mpq_class result;
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 2, static_cast<unsigned long>(std::abs(exponent)));
  if (exponent < 0) {
    result = mpq_class(1, power);
  } else {
    result = mpq_class(power);
  }
  return result;
}

}  // namespace

RationalPoint exactly(const Eigen::Vector3d& p) {
  return {mpq_class(p.data()[0]), mpq_class(p.data()[1]), mpq_class(p.data()[2])};
}

std::vector<RationalPoint> rational_intersection(const Triangle& a, const Triangle& b) {
  Polygon polygon = corners(a);
  for (const HalfSpace& space : half_spaces(b))
    polygon = clip(polygon, space);
  return simplified(polygon);
}

RationalDistance rational_distance(const Triangle& a, const Triangle& b) {
  const Polygon s = corners(a);
  const Polygon t = corners(b);
  RationalDistance result;
  for (int i = 0; i < 3; ++i) {
    consider(result, {s[i], nearest_on_triangle(s[i], t)});
    consider(result, {nearest_on_triangle(t[i], s), t[i]});
    for (int j = 0; j < 3; ++j)
      consider(result, nearest_on_segments(s[i], s[(i + 1) % 3], t[j], t[(j + 1) % 3]));
  }
  return result;
}

mpq_class squared_distance(const RationalPoint& p, const RationalPoint& q) {
  const Point d = minus(p, q);
  return dot(d, d);
}

mpq_class squared_distance(const RationalPoint& p, const Triangle& t) {
  return squared_distance(p, nearest_on_triangle(p, corners(t)));
}

mpq_class ulp_of_coordinates(const Triangle& a, const Triangle& b) {
  mpq_class largest = 0;
  for (const Triangle& t : {a, b}) {
    for (const Point& p : corners(t)) {
      for (const mpq_class& x : p)
        largest = std::max(largest, mpq_class(abs(x)));
    }
  }
  return ulp(largest);
}

mpq_class ulp_of_differences(const Triangle& a, const Triangle& b) {
  mpq_class largest = 0;
  for (const Point& p : corners(a)) {
    for (const Point& q : corners(b)) {
      for (const mpq_class& x : minus(p, q))
        largest = std::max(largest, mpq_class(abs(x)));
    }
  }
  return ulp(largest);
}

bool are_within(const RationalPoint& exact, const Eigen::Vector3d& rounded,
                const mpq_class& reach) {
  const Point other = exactly(rounded);
  bool is_near = true;
  for (int k = 0; k < 3; ++k)
    is_near &= abs(exact[k] - other[k]) <= reach;
  return is_near;
}

}  // namespace graze::oracle
