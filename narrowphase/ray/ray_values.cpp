// Computes where on the ray the triangle is: in twice the precision of double while that is well
// conditioned, else from integers with one rounding.

#include <graze/narrowphase/derived/double_pair.h>
#include <graze/narrowphase/predicates/exact_vector.h>
#include <graze/narrowphase/ray/face_kernels.h>
#include <graze/narrowphase/ray/ray_stages.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace graze::narrowphase {
namespace {

bool is_in_range(double size) {
  return size >= kSmallestFace && size <= kLargestFace;
}

struct PairNormal {
  explicit PairNormal(const Triangle& t)
      : u(PairVector::difference(t.b.data(), t.a.data())),
        v(PairVector::difference(t.c.data(), t.a.data())),
        n(cross(u, v)),
        size(largest_component(u) * largest_component(v)),
        is_in_range(narrowphase::is_in_range(largest_component(u)) &&
                    narrowphase::is_in_range(largest_component(v))) {}

  PairVector u, v, n;
  double size;
  bool is_in_range;
};

/// Holds a ratio of two integers, the second not 0, times 2^exponent.
struct Ratio {
  BigInteger numerator;
  BigInteger denominator;  ///< positive
  Ratio(const BigInteger& n, const BigInteger& d)
      : numerator(d.sign() == Sign::Negative ? BigInteger() - n : n),
        denominator(d.sign() == Sign::Negative ? BigInteger() - d : d) {}
};

/// Holds the input as integers: w, n and so on as in ray_stages.h.
class ExactRay {
 public:
  ExactRay(const Triangle& t, const PreparedRay& ray) : ray_(ray), unit_({}) {
    for (const double* values :
         {t.a.data(), t.b.data(), t.c.data(), ray.ray.origin.data(), ray.ray.direction.data()})
      unit_.include(values, 3);
    const double zero[3] = {0, 0, 0};
    direction = BigVector::difference(ray.ray.direction.data(), zero, unit_);
  }

  BigVector minus(const double* a, const double* b) const {
    return BigVector::difference(a, b, unit_);
  }
  BigVector from_origin(const double* p) const { return minus(p, ray_.ray.origin.data()); }

  /// Returns the place at the point origin + ratio * direction.
  RayPlace place(const Ratio& at) const {
    const BigInteger* d[3] = {&direction.x, &direction.y, &direction.z};
    RayPlace place;
    place.scale = rounded_ratio(at.numerator, at.denominator, ray_.scaled.exponent);
    for (int k = 0; k < 3; ++k) {
      const BigInteger sum =
          unit_.of(ray_.ray.origin.data()[k]) * at.denominator + *d[k] * at.numerator;
      place.point.data()[k] = rounded_ratio(sum, at.denominator, unit_.exponent());
    }
    return place;
  }

  BigVector direction;

 private:
  const PreparedRay& ray_;
  CommonUnit unit_;
};

const BigInteger& component(const BigVector& v, int k) {
  return k == 0 ? v.x : (k == 1 ? v.y : v.z);
}

/// Returns a component that is not zero in one of the two, or -1.
int any_component(const BigVector& p, const BigVector& q) {
  for (int k = 0; k < 3; ++k) {
    if (component(p, k).sign() != Sign::Zero || component(q, k).sign() != Sign::Zero) return k;
  }
  return -1;
}

/// Gathers where edges are met by a ray in their plane: a segment of the line, of which only the
/// ends matter.
class PlanarMeeting {
 public:
  explicit PlanarMeeting(const ExactRay& exact) : exact_(exact) {}

  void include(const Ratio& at) {
    has_behind_ |= at.numerator.sign() != Sign::Positive;
    has_ahead_ |= at.numerator.sign() != Sign::Negative;
    const RayPlace place = exact_.place(at);
    if (!nearest_ || place.scale < nearest_->scale) nearest_ = place;
  }

  std::optional<RayPlace> first(const Eigen::Vector3d& origin) const {
    if (has_behind_ && has_ahead_) return RayPlace{0, origin};
    return has_ahead_ ? nearest_ : std::nullopt;
  }

 private:
  const ExactRay& exact_;
  std::optional<RayPlace> nearest_;
  bool has_behind_ = false;
  bool has_ahead_ = false;
};

/// p x d and q x d are multiples of one vector, p and q being seen from the origin: the edge meets
/// the line unless both are on one side. With e = q - p the line meets that of the edge at (p x e)
/// / (d x e); an edge on the line is met from p to q.
void include_edge(const ExactRay& exact, const double* from, const double* to,
                  PlanarMeeting& meeting) {
  const BigVector p = exact.from_origin(from), q = exact.from_origin(to);
  const BigVector beside_p = cross(p, exact.direction), beside_q = cross(q, exact.direction);
  const int k = any_component(beside_p, beside_q);
  if (k < 0) {
    const int along = any_component(exact.direction, exact.direction);
    meeting.include({component(p, along), component(exact.direction, along)});
    meeting.include({component(q, along), component(exact.direction, along)});
    return;
  }
  const BigInteger& side_p = component(beside_p, k);
  const BigInteger& side_q = component(beside_q, k);
  if (side_p.sign() == side_q.sign()) return;
  const BigVector e = exact.minus(to, from);
  meeting.include({component(cross(p, e), k), component(cross(exact.direction, e), k)});
}

Eigen::Vector3d unit_of(const double* v) {
  const double largest = std::max(std::abs(v[0]), std::max(std::abs(v[1]), std::abs(v[2])));
  const double scaled[3] = {v[0] / largest, v[1] / largest, v[2] / largest};
  const double length =
      std::sqrt((scaled[0] * scaled[0] + scaled[1] * scaled[1]) + scaled[2] * scaled[2]);
  return {scaled[0] / length, scaled[1] / length, scaled[2] / length};
}

Eigen::Vector3d exact_unit_normal(const Triangle& t) {
  CommonUnit unit({});
  for (const double* corner : {t.a.data(), t.b.data(), t.c.data()})
    unit.include(corner, 3);
  const BigVector n = cross(BigVector::difference(t.b.data(), t.a.data(), unit),
                            BigVector::difference(t.c.data(), t.a.data(), unit));
  // Sizes are relative to the sum of sizes, which is not zero, and does not overflow.
  BigInteger size;
  for (int k = 0; k < 3; ++k) {
    const BigInteger& c = component(n, k);
    size = c.sign() == Sign::Negative ? size - c : size + c;
  }
  const double share[3] = {rounded_ratio(n.x, size, 0), rounded_ratio(n.y, size, 0),
                           rounded_ratio(n.z, size, 0)};
  return unit_of(share);
}

}  // namespace

RayPlace place_on_face(const Triangle& triangle, const PreparedRay& ray) {
  const PairNormal normal(triangle);
  const PairVector w = PairVector::difference(triangle.a.data(), ray.ray.origin.data());
  const double* d = ray.scaled.component;
  const double size_w = largest_component(w);
  if (normal.is_in_range && is_in_range(size_w)) {
    const DoublePair ahead = dot(normal.n, w);
    const DoublePair along = dot(normal.n, PairVector{{d[0], 0}, {d[1], 0}, {d[2], 0}});
    // The largest component of d is less than 2.
    if (std::abs(ahead.high) >= kWellConditioned * (normal.size * size_w) &&
        std::abs(along.high) >= kWellConditioned * 2 * normal.size) {
      return point_at((ahead / along).high, ray);
    }
  }
  const ExactRay exact(triangle, ray);
  const BigVector n = cross(exact.minus(triangle.b.data(), triangle.a.data()),
                            exact.minus(triangle.c.data(), triangle.a.data()));
  return exact.place(Ratio(dot(n, exact.from_origin(triangle.a.data())), dot(n, exact.direction)));
}

std::optional<RayPlace> place_in_plane(const Triangle& triangle, const PreparedRay& ray) {
  const ExactRay exact(triangle, ray);
  PlanarMeeting meeting(exact);
  include_edge(exact, triangle.a.data(), triangle.b.data(), meeting);
  include_edge(exact, triangle.b.data(), triangle.c.data(), meeting);
  include_edge(exact, triangle.c.data(), triangle.a.data(), meeting);
  return meeting.first(ray.ray.origin);
}

Eigen::Vector3d unit_normal(const Triangle& triangle) {
  const PairNormal normal(triangle);
  const double n[3] = {normal.n.x.high, normal.n.y.high, normal.n.z.high};
  if (normal.is_in_range && largest_component(normal.n) >= kWellConditioned * normal.size)
    return unit_of(n);
  return exact_unit_normal(triangle);
}

}  // namespace graze::narrowphase
