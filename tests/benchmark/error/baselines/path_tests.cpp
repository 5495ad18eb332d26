#include "tests/benchmark/error/baselines/path_tests.h"

#include <algorithm>
#include <array>
#include <vector>

namespace graze::benchmark {
namespace {

template <typename Real>
struct Cubic {
  Real c[4];  ///< the coefficient of t^i

  Real operator()(Real t) const { return ((c[3] * t + c[2]) * t + c[1]) * t + c[0]; }
};

template <typename Real>
struct RealRoots {
  Real root[3];
  int count = 0;

  void add(Real t) { root[count++] = t; }
};

/// (a x b) . c of three vectors that change steadily, by what they are and how they change.
template <typename Real>
Cubic<Real> triple(const PlainVector<Real> (&at)[3], const PlainVector<Real> (&by)[3]) {
  const auto of = [](const auto& a, const auto& b, const auto& c) { return dot(cross(a, b), c); };
  return {{of(at[0], at[1], at[2]),
           of(by[0], at[1], at[2]) + of(at[0], by[1], at[2]) + of(at[0], at[1], by[2]),
           of(by[0], by[1], at[2]) + of(by[0], at[1], by[2]) + of(at[0], by[1], by[2]),
           of(by[0], by[1], by[2])}};
}

/// A root between two places of different signs, by halving.
template <typename Real>
Real root_between(const Cubic<Real>& f, Real low, Real high) {
  const bool is_low_negative = f(low) < 0;
  for (int i = 0; i < 60; ++i) {
    const Real middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) break;
    ((f(middle) < 0) == is_low_negative ? low : high) = middle;
  }
  return low;
}

/// From `first` to `last`, one in each stretch between places where it turns; ends and turns count
/// where the value is zero.
template <typename Real>
RealRoots<Real> roots_of(const Cubic<Real>& f, Real first, Real last) {
  Real stop[4] = {first};
  int stops = 1;
  const Real a = 3 * f.c[3], b = 2 * f.c[2], c = f.c[1];
  const Real square = b * b - 4 * a * c;
  if (a != 0 && square >= 0) {
    const Real q = -(b + std::copysign(std::sqrt(square), b)) / 2;
    Real turn[2] = {q / a, q != 0 ? c / q : Real(0)};
    if (turn[0] > turn[1]) std::swap(turn[0], turn[1]);
    for (const Real t : turn) {
      if (t > first && t < last) stop[stops++] = t;
    }
  } else if (a == 0 && b != 0 && -c / b > first && -c / b < last) {
    stop[stops++] = -c / b;
  }
  stop[stops++] = last;
  RealRoots<Real> roots;
  for (int i = 0; i + 1 < stops && roots.count < 3; ++i) {
    const Real low = f(stop[i]), high = f(stop[i + 1]);
    if (low == 0) {
      roots.add(stop[i]);
    } else if ((low < 0) != (high < 0) || high == 0) {
      roots.add(high == 0 ? stop[i + 1] : root_between(f, stop[i], stop[i + 1]));
    }
  }
  return roots;
}

template <typename Real>
struct Places {
  Real at[4][3];

  Places(const PlainPaths<Real>& paths, Real t) {
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 3; ++k)
        at[i][k] = paths.start[i][k] + t * (paths.end[i][k] - paths.start[i][k]);
    }
  }
};

/// Both weights along two vectors by the normal equations; false if these have no solution.
template <typename Real>
bool weights(const PlainVector<Real>& u, const PlainVector<Real>& v, const PlainVector<Real>& w,
             Real (&of)[2]) {
  const Real uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
  const Real determinant = uu * vv - uv * uv;
  of[0] = (wu * vv - wv * uv) / determinant;
  of[1] = (wv * uu - wu * uv) / determinant;
  return determinant != 0;
}

template <typename Real>
bool is_in_triangle(const Places<Real>& p, Real epsilon) {
  Real of[2];
  return weights(difference(p.at[2], p.at[1]), difference(p.at[3], p.at[1]),
                 difference(p.at[0], p.at[1]), of) &&
         of[0] >= -epsilon && of[1] >= -epsilon && of[0] + of[1] <= 1 + epsilon;
}

template <typename Real>
bool do_edges_cross(const Places<Real>& p, Real epsilon) {
  Real of[2];
  if (!weights(difference(p.at[1], p.at[0]), difference(p.at[2], p.at[3]),
               difference(p.at[2], p.at[0]), of))
    return false;
  return of[0] >= -epsilon && of[0] <= 1 + epsilon && of[1] >= -epsilon && of[1] <= 1 + epsilon;
}

/// Three vectors from one point to the others are in one plane when all four are.
template <typename Real, typename IsMet>
bool cubic(const PlainPaths<Real>& paths, Real epsilon, const IsMet& is_met) {
  PlainVector<Real> at[3], by[3];
  for (int i = 0; i < 3; ++i) {
    at[i] = difference(paths.start[i + 1], paths.start[0]);
    const PlainVector<Real> last = difference(paths.end[i + 1], paths.end[0]);
    by[i] = {last.x - at[i].x, last.y - at[i].y, last.z - at[i].z};
  }
  const RealRoots<Real> roots = roots_of(triple(at, by), -epsilon, 1 + epsilon);
  for (int i = 0; i < roots.count; ++i) {
    if (is_met(Places<Real>(paths, roots.root[i]), epsilon)) return true;
  }
  return false;
}

/// Parts of time and of two weights, [0, 1] each: from low to low + size.
struct Part {
  std::array<double, 3> low;
  std::array<double, 3> size;
};

/// What a difference of places is over a part: in each of the three arguments it is linear, so that
/// it is between its values at eight corners.
class Inclusion {
 public:
  enum class Kind { Point, Edges };

  Inclusion(const PlainPaths<double>& paths, Kind kind) : paths_(paths), kind_(kind) {
    double largest = 0;
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 3; ++k) {
        largest = std::max({largest, std::abs(paths.start[i][k]), std::abs(paths.end[i][k])});
      }
    }
    rounding_ = 0x1p-48 * largest;  // some thirty operations, of at most four times that size
  }

  bool do_meet() const {
    std::vector<Part> open{{{0, 0, 0}, {1, 1, 1}}};
    for (int looked = 0; !open.empty(); ++looked) {
      if (looked == kMostParts) return true;
      Part part = open.back();
      open.pop_back();
      if (kind_ == Kind::Point && part.low[1] + part.low[2] > 1) continue;
      double widest = 0;
      if (!holds_zero(part, widest)) continue;
      if (widest <= kTolerance) return true;
      const auto axis = static_cast<std::size_t>(
          std::max_element(part.size.begin(), part.size.end()) - part.size.begin());
      part.size[axis] /= 2;
      Part later = part;
      later.low[axis] += part.size[axis];
      open.push_back(later);
      open.push_back(part);
    }
    return false;
  }

 private:
  static constexpr int kMostParts = 100'000;
  static constexpr double kTolerance = 1e-6;

  double value(int k, double t, double u, double v) const {
    double p[4];
    for (int i = 0; i < 4; ++i)
      p[i] = paths_.start[i][k] * (1 - t) + paths_.end[i][k] * t;
    if (kind_ == Kind::Point) return (p[0] - p[1]) - (u * (p[2] - p[1]) + v * (p[3] - p[1]));
    return (p[0] + u * (p[1] - p[0])) - (p[2] + v * (p[3] - p[2]));
  }

  bool holds_zero(const Part& part, double& widest) const {
    for (int k = 0; k < 3; ++k) {
      double low = 0, high = 0;
      for (unsigned corner = 0; corner < 8; ++corner) {
        const auto at = [&](unsigned axis) {
          return part.low[axis] + (corner >> axis & 1 ? part.size[axis] : 0);
        };
        const double f = value(k, at(0), at(1), at(2));
        low = corner == 0 ? f : std::min(low, f);
        high = corner == 0 ? f : std::max(high, f);
      }
      if (low > rounding_ || high < -rounding_) return false;
      widest = std::max(widest, high - low);
    }
    return true;
  }

  const PlainPaths<double>& paths_;
  Kind kind_;
  double rounding_;
};

}  // namespace

template <typename Real>
bool cubic_point(const PlainPaths<Real>& paths, Real epsilon) {
  return cubic(paths, epsilon, is_in_triangle<Real>);
}

template <typename Real>
bool cubic_edges(const PlainPaths<Real>& paths, Real epsilon) {
  return cubic(paths, epsilon, do_edges_cross<Real>);
}

bool inclusion_point(const PlainPaths<double>& paths) {
  return Inclusion(paths, Inclusion::Kind::Point).do_meet();
}

bool inclusion_edges(const PlainPaths<double>& paths) {
  return Inclusion(paths, Inclusion::Kind::Edges).do_meet();
}

template bool cubic_point(const PlainPaths<double>&, double);
template bool cubic_point(const PlainPaths<float>&, float);
template bool cubic_edges(const PlainPaths<double>&, double);
template bool cubic_edges(const PlainPaths<float>&, float);

}  // namespace graze::benchmark
