#include <graze/narrowphase/convex/core/exact_line.h>
#include <graze/narrowphase/derived/double_pair.h>
#include <graze/narrowphase/predicates/exact_vector.h>

#include <cmath>

namespace graze::narrowphase {
namespace {

const double* data(const Vec3& v) {
  return &v.x;
}

/// Takes three corners of a face as normal_of() in hull.cpp does; no three of its corners are on a
/// line.
struct ThreeCorners {
  ThreeCorners(const Hull& hull, const Hull::Face& face)
      : a(hull.exact_corners[hull.loops[face.first]]),
        b(hull.exact_corners[hull.loops[face.first + face.count / 3]]),
        c(hull.exact_corners[hull.loops[face.first + 2 * face.count / 3]]) {}
  const Vec3& a;
  const Vec3& b;
  const Vec3& c;
};

/// Holds corners as seen from the origin, as integers.
class Exactly {
 public:
  Exactly(const Hull& hull, const Vec3& origin) : hull_(hull), origin_(origin), unit_({}) {
    unit_.include(data(hull.middle), 3);
    unit_.include(data(origin), 3);
  }
  /// Takes coordinates into account, before anything is counted.
  void include(const Vec3& v) { unit_.include(data(v), 3); }

  BigVector from_origin(const Vec3& corner) const {
    const auto difference = [&](double c, double m, double o) {
      return unit_.of(c) - unit_.of(m) - unit_.of(o);
    };
    return {difference(corner.x, hull_.middle.x, origin_.x),
            difference(corner.y, hull_.middle.y, origin_.y),
            difference(corner.z, hull_.middle.z, origin_.z)};
  }

  BigVector normal(const ThreeCorners& t) const {
    return cross(BigVector::difference(data(t.b), data(t.a), unit_),
                 BigVector::difference(data(t.c), data(t.a), unit_));
  }

  int exponent() const { return unit_.exponent(); }

 private:
  const Hull& hull_;
  const Vec3& origin_;
  CommonUnit unit_;
};

struct ExactDirection {
  explicit ExactDirection(const Vec3& d) : unit({d.x, d.y, d.z}) {
    vector = {unit.of(d.x), unit.of(d.y), unit.of(d.z)};
  }
  CommonUnit unit;
  BigVector vector;
};

// As in ray/ray_values.cpp, n . w and n . d are off by less than 2^-95 of the product of sizes, so
// that above this share of it their quotient rounds to within 0.51 ulp.
constexpr double kWellConditioned = 0x1p-32;
constexpr double kSmallest = 0x1p-200;
constexpr double kLargest = 0x1p+200;

bool is_in_range(double size) {
  return size >= kSmallest && size <= kLargest;
}

}  // namespace

Sign ExactLine::side_of_edge(std::uint32_t from, std::uint32_t to) const {
  const Vec3& p = hull_.exact_corners[from];
  const Vec3& q = hull_.exact_corners[to];
  Exactly exactly(hull_, origin_);
  exactly.include(p);
  exactly.include(q);
  const BigVector normal = cross(exactly.from_origin(p), exactly.from_origin(q));
  return dot(normal, ExactDirection(direction_).vector).sign();
}

Sign ExactLine::side_of_origin(const Hull::Face& face) const {
  const ThreeCorners t(hull_, face);
  Exactly exactly(hull_, origin_);
  for (const Vec3* corner : {&t.a, &t.b, &t.c})
    exactly.include(*corner);
  return dot(exactly.normal(t), exactly.from_origin(t.a)).sign();
}

double ExactLine::distance(const Hull::Face& face) const {
  const ThreeCorners t(hull_, face);
  const PairVector u = PairVector::difference(data(t.b), data(t.a));
  const PairVector v = PairVector::difference(data(t.c), data(t.a));
  const PairVector o{{origin_.x, 0}, {origin_.y, 0}, {origin_.z, 0}};
  const PairVector w = PairVector::difference(data(t.a), data(hull_.middle)) - o;
  const double size_u = largest_component(u), size_v = largest_component(v);
  const double size_w = largest_component(w);
  if (is_in_range(size_u) && is_in_range(size_v) && is_in_range(size_w)) {
    const PairVector n = cross(u, v);
    const DoublePair ahead = dot(n, w);
    const DoublePair along =
        dot(n, PairVector{{direction_.x, 0}, {direction_.y, 0}, {direction_.z, 0}});
    const double size = size_u * size_v;
    if (std::abs(ahead.high) >= kWellConditioned * (size * size_w) &&
        std::abs(along.high) >= kWellConditioned * (size * largest(direction_)))
      return (ahead / along).high;
  }
  return distance_by_integers(face);
}

double ExactLine::distance_by_integers(const Hull::Face& face) const {
  const ThreeCorners t(hull_, face);
  Exactly exactly(hull_, origin_);
  for (const Vec3* corner : {&t.a, &t.b, &t.c})
    exactly.include(*corner);
  const ExactDirection direction(direction_);
  const BigVector n = exactly.normal(t);
  BigInteger ahead = dot(n, exactly.from_origin(t.a));
  BigInteger along = dot(n, direction.vector);
  if (along.sign() == Sign::Negative) {
    ahead = BigInteger() - ahead;
    along = BigInteger() - along;
  }
  return rounded_ratio(ahead, along, exactly.exponent() - direction.unit.exponent());
}

}  // namespace graze::narrowphase
