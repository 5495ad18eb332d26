#include "tests/narrowphase/translation/rational_cast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace graze::oracle {
namespace {

using IntegerVector = std::array<mpz_class, 3>;

/// Counts all in units of the smallest lowest bit.
class Units {
 public:
  void include(const Eigen::Vector3d& p) {
    for (int k = 0; k < 3; ++k) {
      if (p.data()[k] == 0) continue;
      int exponent = 0;
      std::frexp(p.data()[k], &exponent);
      unit_ = std::min(unit_, exponent - 53);
    }
  }
  IntegerVector of(const Eigen::Vector3d& p) const {
    IntegerVector v;
    for (int k = 0; k < 3; ++k) {
      int exponent = 0;
      v[k] = mpz_class(std::ldexp(std::frexp(p.data()[k], &exponent), 53));
      if (v[k] != 0) v[k] <<= exponent - 53 - unit_;
    }
    return v;
  }

 private:
  int unit_ = 1024;
};

IntegerVector minus(const IntegerVector& a, const IntegerVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

IntegerVector cross(const IntegerVector& a, const IntegerVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

mpz_class dot(const IntegerVector& a, const IntegerVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

bool is_zero(const IntegerVector& v) {
  return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

/// What all normals leave of the times.
class Times {
 public:
  /// Of the hulls of some corners, with edges from some of them to others.
  using Corners = std::vector<Eigen::Vector3d>;
  using Edges = std::vector<std::array<std::size_t, 2>>;
  Times(const Corners& a, const Edges& edges_a, const Corners& b, const Edges& edges_b,
        const Eigen::Vector3d& d) {
    Units units;
    for (const Corners* corners : {&a, &b}) {
      for (const Eigen::Vector3d& p : *corners)
        units.include(p);
    }
    units.include(d);
    direction_ = units.of(d);
    for (const Eigen::Vector3d& p : a) {
      for (const Eigen::Vector3d& q : b)
        differences_.push_back(minus(units.of(p), units.of(q)));
    }
    std::vector<IntegerVector> edges;
    for (const auto& [from, to] : edges_a)
      edges.push_back(minus(units.of(a[to]), units.of(a[from])));
    for (const auto& [from, to] : edges_b)
      edges.push_back(minus(units.of(b[to]), units.of(b[from])));
    const std::size_t count = edges.size();
    for (std::size_t k = 0; k < 3; ++k) {
      IntegerVector axis{0, 0, 0};
      axis[k] = 1;
      ask(axis);
      edges.push_back(axis);
    }
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = i + 1; k < edges.size(); ++k)
        ask(cross(edges[i], edges[k]));
    }
  }

  bool are_none() const { return is_empty_ || (has_low_ && has_high_ && low_ > high_); }
  bool have_zero() const {
    return !are_none() && (!has_low_ || low_ <= 0) && (!has_high_ || high_ >= 0);
  }
  bool cross_from_start() const { return crosses_; }
  const mpq_class& low() const { return low_; }

 private:
  void ask(const IntegerVector& n) {
    if (is_zero(n)) return;
    mpz_class lowest = dot(n, differences_[0]), highest = lowest;
    for (const IntegerVector& difference : differences_) {
      const mpz_class value = dot(n, difference);
      if (value < lowest) lowest = value;
      if (value > highest) highest = value;
    }
    mpz_class along = dot(n, direction_);
    // Inside of all at a time that is just above 0.
    crosses_ = crosses_ && (lowest < 0 || (lowest == 0 && along > 0)) &&
               (highest > 0 || (highest == 0 && along < 0));
    if (along == 0) {
      is_empty_ = is_empty_ || lowest > 0 || highest < 0;
      return;
    }
    mpq_class from(lowest, along), to(highest, along);
    from.canonicalize();
    to.canonicalize();
    if (along < 0) std::swap(from, to);
    if (!has_low_ || from > low_) low_ = from;
    if (!has_high_ || to < high_) high_ = to;
    has_low_ = has_high_ = true;
  }

  IntegerVector direction_;
  std::vector<IntegerVector> differences_;
  mpq_class low_, high_;
  bool has_low_ = false, has_high_ = false;
  bool is_empty_ = false;
  bool crosses_ = true;
};

}  // namespace

double floor_of(const mpq_class& time) {
  double value = time.get_d();
  while (mpq_class(value) > time)
    value = std::nextafter(value, -1.0);
  while (mpq_class(std::nextafter(value, 2.0)) <= time)
    value = std::nextafter(value, 2.0);
  return value;
}

namespace {

const Times::Edges kEdges{{0, 1}, {1, 2}, {2, 0}};

RationalCast answer(const Times& times, StartContact start) {
  if (times.are_none()) return {};
  if (times.have_zero()) {
    if (start == StartContact::IsLeft && !times.cross_from_start()) return {};
    return {FirstContact{0, true}, 0};
  }
  if (times.low() <= 0 || times.low() > 1) return {};
  return {FirstContact{floor_of(times.low()), false}, times.low()};
}

}  // namespace

RationalCast rational_cast(const Triangle& a, const Triangle& b, const Eigen::Vector3d& d,
                           StartContact start) {
  return answer(Times({a.a, a.b, a.c}, kEdges, {b.a, b.b, b.c}, kEdges, d), start);
}

RationalCast rational_cast(const Triangle& a, const Aabb& box, const Eigen::Vector3d& d) {
  Times::Corners corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back((i & 1 ? box.max : box.min).x(), (i & 2 ? box.max : box.min).y(),
                         (i & 4 ? box.max : box.min).z());
  return answer(Times({a.a, a.b, a.c}, kEdges, corners, {{0, 1}, {0, 2}, {0, 4}}, d),
                StartContact::Counts);
}

std::string text_of(const Eigen::Vector3d& point) {
  char text[128];
  std::snprintf(text, sizeof(text), "{%a, %a, %a}", point.data()[0], point.data()[1],
                point.data()[2]);
  return text;
}

std::string text_of(const Triangle& t) {
  return "{" + text_of(t.a) + ", " + text_of(t.b) + ", " + text_of(t.c) + "}";
}

}  // namespace graze::oracle
