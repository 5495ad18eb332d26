#include "tests/narrowphase/translation/rational_ball.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace graze::oracle {
namespace {

using Vector = std::array<mpq_class, 3>;

Vector vector_of(const Eigen::Vector3d& p) {
  return {mpq_class(p[0]), mpq_class(p[1]), mpq_class(p[2])};
}

Vector plus(const Vector& a, const Vector& b, const mpq_class& factor) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

Vector minus(const Vector& a, const Vector& b) {
  return plus(a, b, -1);
}

mpq_class dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// p + q s + r s^2
struct Square {
  mpq_class p, q, r;

  mpq_class at(const mpq_class& s) const { return p + s * (q + s * r); }
};

/// |v + s w|^2
Square square_of(const Vector& v, const Vector& w) {
  return {dot(v, v), 2 * dot(v, w), dot(w, w)};
}

/// The part of a vector that a line along `edge` does not have.
Vector across(const Vector& v, const Vector& edge) {
  return plus(v, edge, -dot(v, edge) / dot(edge, edge));
}

class Path {
 public:
  Path(const Triangle& t, const Sphere& ball, const Eigen::Vector3d& d)
      : corner_{vector_of(t.a), vector_of(t.b), vector_of(t.c)},
        centre_(vector_of(ball.centre)),
        d_(vector_of(d)),
        radius2_(mpq_class(ball.radius) * mpq_class(ball.radius)) {
    for (int i = 0; i < 3; ++i)
      edge_[i] = minus(corner_[(i + 1) % 3], corner_[i]);
    normal_ = cross(edge_[0], minus(corner_[2], corner_[0]));
    has_area_ = dot(normal_, normal_) != 0;
  }

  /// The squared distance from the feature that is nearest at a time, less r^2.
  Square nearest_at(const mpq_class& time) const {
    const Vector p = plus(centre_, d_, time);
    if (has_area_ && is_over_face(p)) {
      const mpq_class square = dot(normal_, normal_);
      const mpq_class height = dot(minus(centre_, corner_[0]), normal_), rise = dot(d_, normal_);
      return {height * height / square - radius2_, 2 * height * rise / square,
              rise * rise / square};
    }
    std::optional<Square> nearest;
    const auto take = [&](Square square) {
      square.p -= radius2_;
      if (!nearest || square.at(time) < nearest->at(time)) nearest = square;
    };
    for (int i = 0; i < 3; ++i) {
      take(square_of(minus(centre_, corner_[i]), d_));
      if (dot(edge_[i], edge_[i]) == 0) continue;
      const mpq_class along = dot(minus(p, corner_[i]), edge_[i]);
      if (along <= 0 || along >= dot(edge_[i], edge_[i])) continue;
      take(square_of(across(minus(centre_, corner_[i]), edge_[i]), across(d_, edge_[i])));
    }
    return *nearest;
  }

  /// Times between which one feature is nearest, 0 and 1 among them.
  std::vector<mpq_class> times() const {
    std::vector<mpq_class> times{0, 1};
    const auto take = [&](const mpq_class& offset, const mpq_class& slope) {
      if (slope == 0) return;
      const mpq_class time = -offset / slope;
      if (time > 0 && time < 1) times.push_back(time);
    };
    for (int i = 0; i < 3; ++i) {
      for (int end = 0; end < 2; ++end)
        take(dot(minus(centre_, corner_[(i + end) % 3]), edge_[i]), dot(d_, edge_[i]));
      // Through an edge, at right angles to the face.
      const Vector inward = cross(normal_, edge_[i]);
      take(dot(minus(centre_, corner_[i]), inward), dot(d_, inward));
    }
    std::sort(times.begin(), times.end());
    return times;
  }

 private:
  bool is_over_face(const Vector& p) const {
    for (int i = 0; i < 3; ++i) {
      if (dot(minus(p, corner_[i]), cross(normal_, edge_[i])) < 0) return false;
    }
    return true;
  }

  std::array<Vector, 3> corner_;
  Vector centre_;
  Vector d_;
  mpq_class radius2_;
  std::array<Vector, 3> edge_;
  Vector normal_;
  bool has_area_;
};

double rounded_down(const QuadraticTime& time) {
  std::uint64_t low = 0, high = std::bit_cast<std::uint64_t>(1.0) + 1;
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    (time.compare(mpq_class(std::bit_cast<double>(middle))) > 0 ? high : low) = middle;
  }
  return std::bit_cast<double>(low);
}

/// The first time in (from, to] at which a square that is positive at `from` is zero.
std::optional<QuadraticTime> closing(const Square& s, const mpq_class& from, const mpq_class& to) {
  if (s.r == 0 || s.q * s.q < 4 * s.p * s.r) return std::nullopt;
  const mpq_class vertex = -s.q / (2 * s.r);
  if (vertex <= from || (vertex > to && s.at(to) > 0)) return std::nullopt;
  return QuadraticTime{s.r, s.q, s.p};
}

}  // namespace

int QuadraticTime::compare(const mpq_class& x) const {
  if (a == 0) return cmp(x, -c);
  const int side = cmp(x, -b / (2 * a));
  const int value = sgn(mpq_class(a * x * x + b * x + c));
  if (side > 0 || value < 0) return 1;
  return value == 0 ? 0 : -1;
}

mpf_class QuadraticTime::value() const {
  constexpr unsigned kBits = 6000;
  if (a == 0) return mpf_class(mpq_class(-c), kBits);
  const mpf_class root = sqrt(mpf_class(mpq_class(b * b - 4 * a * c), kBits));
  // Without cancellation: b is negative.
  return mpf_class(mpq_class(2 * c), kBits) / (root - mpf_class(b, kBits));
}

RationalBallCast rational_cast(const Triangle& triangle, const Sphere& ball,
                               const Eigen::Vector3d& d, StartContact start) {
  const Path path(triangle, ball, d);
  const Square at_start = path.nearest_at(0);
  if (at_start.p <= 0) {
    // A touch counts for what goes in.
    if (start == StartContact::IsLeft && at_start.p == 0 && at_start.q >= 0) return {};
    return {FirstContact{0, true}, {0, 0, 0}};
  }
  const std::vector<mpq_class> times = path.times();
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    if (times[i] == times[i + 1]) continue;
    const mpq_class middle = (times[i] + times[i + 1]) / 2;
    const auto time = closing(path.nearest_at(middle), times[i], times[i + 1]);
    if (time) return {FirstContact{rounded_down(*time), false}, *time};
  }
  return {};
}

}  // namespace graze::oracle
