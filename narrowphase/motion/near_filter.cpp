// A plane that keeps two hulls further apart than s at both ends of a stretch of time does so
// throughout, for points go straight: along any direction q the offset of two points changes
// steadily. Good directions lead from one nearest point to the other; any error of theirs costs a
// sure answer, never a right one.
//
// Rounding is bounded as follows, with u the unit roundoff and M the largest coordinate. A point at
// time t, x + t (y - x), is off by u of the difference, of the product and of the sum, 5 M u at
// most, and an offset of two by 12 M u. Its product with q is off by 4 u of 2 M S and 12 M u S
// more, S being the sum of the components of q: 20.1 M u S in all. s |q| is off by 3.6 u of itself.
// What underflows is below 2^-1000, for q is not tiny.

#include <graze/narrowphase/motion/near_contact.h>

#include <algorithm>
#include <cmath>

namespace graze::narrowphase {
namespace {

constexpr double kUnitRoundoff = 0x1p-53;
constexpr double kOffsetBound = 24 * kUnitRoundoff;
constexpr double kClearanceGrowth = 1 + 8 * kUnitRoundoff;
constexpr double kUnderflow = 0x1p-1000;

// Where lengths and directions are between these nothing overflows, and no square underflows.
constexpr double kSmallest = 0x1p-200;
constexpr double kLargest = 0x1p200;

constexpr int kMostSplits = 6;

struct Vector {
  double x, y, z;
};

Vector minus(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vector plus(const Vector& a, const Vector& b, double factor) {
  return {a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z};
}
double dot(const Vector& a, const Vector& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Holds the four points at one time.
struct FourPoints {
  Vector at[4];
};

double within_one(double value) {
  return std::min(std::max(value, 0.0), 1.0);
}

Vector nearest_on_edge(const Vector& p, const Vector& from, const Vector& to) {
  const Vector edge = minus(to, from);
  const double square = dot(edge, edge);
  const double along = square > 0 ? within_one(dot(minus(p, from), edge) / square) : 0;
  return plus(from, edge, along);
}

void take_shorter(Vector& shortest, const Vector& other) {
  if (dot(other, other) < dot(shortest, shortest)) shortest = other;
}

/// Returns roughly the vector from the nearest point of the triangle to the point.
Vector offset_of_point(const FourPoints& p) {
  const Vector& point = p.at[0];
  Vector shortest = minus(point, p.at[1]);
  for (int i = 1; i <= 3; ++i)
    take_shorter(shortest, minus(point, nearest_on_edge(point, p.at[i], p.at[i % 3 + 1])));
  const Vector normal = cross(minus(p.at[2], p.at[1]), minus(p.at[3], p.at[1]));
  bool is_over_face = true;
  for (int i = 1; i <= 3; ++i) {
    const Vector area = cross(minus(p.at[i], point), minus(p.at[i % 3 + 1], point));
    is_over_face = is_over_face && dot(area, normal) > 0;
  }
  if (!is_over_face) return shortest;
  const double side = dot(minus(point, p.at[1]), normal) < 0 ? -1 : 1;
  return {side * normal.x, side * normal.y, side * normal.z};
}

/// Returns roughly the vector from the nearest point of the last edge to that of the first.
Vector offset_of_edges(const FourPoints& p) {
  Vector shortest = minus(p.at[0], p.at[2]);
  for (int i = 0; i < 2; ++i) {
    take_shorter(shortest, minus(p.at[i], nearest_on_edge(p.at[i], p.at[2], p.at[3])));
    take_shorter(shortest, minus(nearest_on_edge(p.at[2 + i], p.at[0], p.at[1]), p.at[2 + i]));
  }
  const Vector e = minus(p.at[1], p.at[0]), f = minus(p.at[3], p.at[2]);
  const Vector w = minus(p.at[2], p.at[0]), across = cross(e, f);
  const double size = dot(across, across);
  const double on_e = dot(cross(w, f), across), on_f = dot(cross(w, e), across);
  if (!(on_e > 0 && on_e < size && on_f > 0 && on_f < size)) return shortest;
  const double side = dot(w, across) > 0 ? -1 : 1;
  return {side * across.x, side * across.y, side * across.z};
}

class Filter {
 public:
  Filter(const FourPaths& paths, double clearance)
      : paths_(paths),
        clearance_(clearance),
        first_count_(paths.kind == PathPair::EdgeEdge ? 2 : 1) {
    double largest = clearance;
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 3; ++k)
        largest =
            std::max(largest, std::max(std::abs(paths.start[i][k]), std::abs(paths.end[i][k])));
    }
    largest_ = largest;
  }

  bool is_in_range() const { return largest_ > kSmallest && largest_ < kLargest; }

  FourPoints at(double t) const {
    FourPoints points;
    for (int i = 0; i < 4; ++i) {
      const double *s = paths_.start[i], *e = paths_.end[i];
      points.at[i] = {s[0] + t * (e[0] - s[0]), s[1] + t * (e[1] - s[1]), s[2] + t * (e[2] - s[2])};
    }
    return points;
  }

  struct Moment {
    double time;
    FourPoints points;
  };

  bool are_further(const Moment& from, const Moment& to, int halvings) const {
    if (does_part(offset(from.points), from.points, to.points) ||
        does_part(offset(to.points), from.points, to.points))
      return true;
    if (halvings == 0) return false;
    const double time = 0.5 * (from.time + to.time);
    const Moment middle{time, at(time)};
    return are_further(from, middle, halvings - 1) && are_further(middle, to, halvings - 1);
  }

 private:
  Vector offset(const FourPoints& p) const {
    return paths_.kind == PathPair::EdgeEdge ? offset_of_edges(p) : offset_of_point(p);
  }

  bool does_part(const Vector& offset, const FourPoints& from, const FourPoints& to) const {
    const double largest =
        std::max(std::abs(offset.x), std::max(std::abs(offset.y), std::abs(offset.z)));
    if (!(largest > 0 && largest < 0x1p1000)) return false;
    const Vector q{offset.x / largest, offset.y / largest, offset.z / largest};
    const double size = (std::abs(q.x) + std::abs(q.y)) + std::abs(q.z);
    const double least = clearance_ * std::sqrt(dot(q, q)) * kClearanceGrowth +
                         (kOffsetBound * largest_ * size + kUnderflow);
    for (const FourPoints* points : {&from, &to}) {
      for (int i = 0; i < first_count_; ++i) {
        for (int k = first_count_; k < 4; ++k) {
          if (!(dot(minus(points->at[i], points->at[k]), q) > least)) return false;
        }
      }
    }
    return true;
  }

  const FourPaths& paths_;
  double clearance_;
  int first_count_;
  double largest_;
};

}  // namespace

bool are_surely_further(const FourPaths& paths, double clearance, double until) {
  const Filter filter(paths, clearance);
  if (!filter.is_in_range()) return false;
  return filter.are_further({0, filter.at(0)}, {until, filter.at(until)}, kMostSplits);
}

}  // namespace graze::narrowphase
