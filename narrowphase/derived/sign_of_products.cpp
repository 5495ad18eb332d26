// Forward error bounds as in predicates.cpp: u is the unit roundoff, n the smallest double;
// P, Q, R, S are the largest components of the four differences, each of which is off by a factor
// (1 + u).

#include <graze/narrowphase/derived/sign_of_products.h>
#include <graze/narrowphase/predicates/exact_vector.h>
#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::narrowphase {
namespace {

constexpr double kUnitRoundoff = 0x1p-53;

// p . q: three products, off by 3 u P Q each, and sums that round at most 2 P Q and 3 P Q: 14 u P Q
// with all second order below 0.01 u P Q.
constexpr double kDotBound = 15 * kUnitRoundoff;

// (p x q) . r: as kBound3d in predicates.cpp, six monomials with eight roundings each:
// 48.01 u P Q R.
constexpr double kTripleBound = 50 * kUnitRoundoff;

// (p x q) . (r x s): a component of a cross product is at most 2 P Q, and off by 8.01 u P Q (two
// products with three roundings, and one of their difference). Their three products are off by 3 (2
// * 2 * 8.01) u P Q R S from that, 12 u P Q R S from their own rounding, and their sums round 8 and
// 12 P Q R S: 129 u P Q R S.
constexpr double kCrossProductsBound = 132 * kUnitRoundoff;

// Products of two sizes between these make no product of four overflow, and an underflow of n in
// any of them is below 2^-1074 + 500 of the largest size, less than 2^-100 u of what bounds it. The
// spare u in each constant covers it and the rounding of the bound.
constexpr double kSmallest = 0x1p-450;
constexpr double kLargest = 0x1p+450;

struct Vector {
  explicit Vector(Step step)
      : x(step.to[0] - step.from[0]), y(step.to[1] - step.from[1]), z(step.to[2] - step.from[2]) {}
  Vector(double along_x, double along_y, double along_z) : x(along_x), y(along_y), z(along_z) {}

  double size() const { return std::max(std::max(std::abs(x), std::abs(y)), std::abs(z)); }

  double x, y, z;
};

Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

bool is_in_range(double size) {
  return size >= kSmallest && size <= kLargest;
}

std::optional<Sign> sure_sign(double value, double bound) {
  if (value > bound) return Sign::Positive;
  if (value < -bound) return Sign::Negative;
  return std::nullopt;
}

BigVector exactly(Step step, const CommonUnit& unit) {
  return BigVector::difference(step.to, step.from, unit);
}

CommonUnit common_unit(std::initializer_list<Step> steps) {
  CommonUnit unit({});
  for (const Step& step : steps) {
    unit.include(step.from, 3);
    unit.include(step.to, 3);
  }
  return unit;
}

}  // namespace

// A computed difference is zero only if the exact one is, so sizes of zero are zeros, exactly.

std::optional<Sign> dot_filter(Step p, Step q) {
  const Vector vp(p), vq(q);
  const double size = vp.size() * vq.size();
  if (vp.size() == 0 || vq.size() == 0) return Sign::Zero;
  if (!is_in_range(size)) return std::nullopt;
  return sure_sign(dot(vp, vq), kDotBound * size);
}

std::optional<Sign> triple_filter(Step p, Step q, Step r) {
  const Vector vp(p), vq(q), vr(r);
  const double size = vp.size() * vq.size();
  if (size == 0 || vr.size() == 0) {
    if (vp.size() == 0 || vq.size() == 0 || vr.size() == 0) return Sign::Zero;
    return std::nullopt;
  }
  if (!is_in_range(size) || !is_in_range(vr.size())) return std::nullopt;
  return sure_sign(dot(cross(vp, vq), vr), kTripleBound * (size * vr.size()));
}

std::pair<RoundedTriple, RoundedTriple> rounded_triples(Step p, Step q, Step r, Step s) {
  const Vector vp(p), vq(q);
  const Vector across = cross(vp, vq);
  const double size = vp.size() * vq.size();
  const auto with = [&](const Vector& v) -> RoundedTriple {
    if (!is_in_range(size) || !is_in_range(v.size()))
      return {0, std::numeric_limits<double>::infinity()};
    return {dot(across, v), kTripleBound * (size * v.size())};
  };
  return {with(Vector(r)), with(Vector(s))};
}

double triple_bound(double largest_of_p, Step q, double largest_of_r) {
  return triple_bound(largest_of_p, Vector(q).size(), largest_of_r);
}

double triple_bound(double largest_of_p, double largest_of_q, double largest_of_r) {
  const double size = largest_of_p * largest_of_q;
  if (!is_in_range(size) || !is_in_range(largest_of_r))
    return std::numeric_limits<double>::infinity();
  return kTripleBound * (size * largest_of_r);
}

std::optional<Sign> crosses_filter(Step p, Step q, Step r, Step s) {
  const Vector vp(p), vq(q), vr(r), vs(s);
  if (vp.size() == 0 || vq.size() == 0 || vr.size() == 0 || vs.size() == 0) return Sign::Zero;
  const double size_pq = vp.size() * vq.size();
  const double size_rs = vr.size() * vs.size();
  if (!is_in_range(size_pq) || !is_in_range(size_rs)) return std::nullopt;
  return sure_sign(dot(cross(vp, vq), cross(vr, vs)), kCrossProductsBound * (size_pq * size_rs));
}

Sign sign_of_dot(Step p, Step q) {
  if (const auto sign = dot_filter(p, q)) return *sign;
  const CommonUnit unit = common_unit({p, q});
  return dot(exactly(p, unit), exactly(q, unit)).sign();
}

Sign sign_of_triple(Step p, Step q, Step r) {
  if (const auto sign = triple_filter(p, q, r)) return *sign;
  const CommonUnit unit = common_unit({p, q, r});
  return dot(cross(exactly(p, unit), exactly(q, unit)), exactly(r, unit)).sign();
}

Sign sign_of_cross_products(Step p, Step q, Step r, Step s) {
  if (const auto sign = crosses_filter(p, q, r, s)) return *sign;
  const CommonUnit unit = common_unit({p, q, r, s});
  return dot(cross(exactly(p, unit), exactly(q, unit)), cross(exactly(r, unit), exactly(s, unit)))
      .sign();
}

}  // namespace graze::narrowphase
