#include "tests/engine/rays/line_in_shape.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace graze::tests {
namespace {

using Eigen::Vector3d;
using Wide = mpf_class;

// Numbers that are made without a value have it as well.
[[maybe_unused]] const bool kHasBits = [] {
  mpf_set_default_prec(kBits);
  return true;
}();

Wide wide(double value) {
  return Wide(value, kBits);
}

Wide dot(const WidePoint& a, const WidePoint& b) {
  Wide sum = a.at[0] * b.at[0] + a.at[1] * b.at[1] + a.at[2] * b.at[2];
  return sum;
}

WidePoint cross(const WidePoint& a, const WidePoint& b) {
  WidePoint c;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
    c.at[k] = Wide(a.at[u] * b.at[v] - a.at[v] * b.at[u], kBits);
  }
  return c;
}

WidePoint wide_point(const Vector3d& v) {
  return {{wide(v.x()), wide(v.y()), wide(v.z())}};
}

WidePoint inverse_times(const Pose& pose, const WidePoint& v) {
  const WidePoint x = wide_point(pose.linear().col(0)), y = wide_point(pose.linear().col(1)),
                  z = wide_point(pose.linear().col(2));
  const Wide volume = dot(x, cross(y, z));
  return {
      {dot(cross(y, z), v) / volume, dot(cross(z, x), v) / volume, dot(cross(x, y), v) / volume}};
}

using Stretch = std::optional<WideStretch>;

const Wide& far_away() {
  static const Wide value("1e400", kBits);
  return value;
}

Stretch all() {
  return WideStretch{-far_away(), far_away()};
}

Stretch common(const Stretch& a, const Stretch& b) {
  if (!a || !b) return std::nullopt;
  WideStretch both{std::max(a->enter, b->enter), std::min(a->exit, b->exit)};
  if (both.enter > both.exit) return std::nullopt;
  return both;
}

Stretch joined(const Stretch& a, const Stretch& b) {
  if (!a) return b;
  if (!b) return a;
  return WideStretch{std::min(a->enter, b->enter), std::max(a->exit, b->exit)};
}

/// low <= o + s d <= high, of one coordinate.
Stretch between(const Wide& o, const Wide& d, const Wide& low, const Wide& high) {
  if (d == 0) return o >= low && o <= high ? all() : std::nullopt;
  Wide one = (low - o) / d, other = (high - o) / d;
  if (one > other) std::swap(one, other);
  return WideStretch{one, other};
}

/// a s^2 + 2 b s + c <= 0 for a >= 0.
Stretch below_parabola(const Wide& a, const Wide& b, const Wide& c) {
  if (a == 0) return c <= 0 ? all() : std::nullopt;  // b is 0 then, for sums of squares
  const Wide discriminant = b * b - a * c;
  if (discriminant < 0) return std::nullopt;
  const Wide root = sqrt(discriminant);
  return WideStretch{(-b - root) / a, (-b + root) / a};
}

/// (x / a)^2 + (y / b)^2 + (z / c)^2 <= 1.
Stretch in_ellipsoid(WidePoint o, WidePoint d, const Vector3d& semi) {
  for (std::size_t k = 0; k < 3; ++k) {
    o.at[k] /= wide(semi[static_cast<int>(k)]);
    d.at[k] /= wide(semi[static_cast<int>(k)]);
  }
  return below_parabola(dot(d, d), dot(o, d), Wide(dot(o, o) - 1));
}

Stretch in_tube(const WidePoint& o, const WidePoint& d, double radius) {
  const Wide r = wide(radius);
  return below_parabola(d.at[0] * d.at[0] + d.at[1] * d.at[1],
                        o.at[0] * d.at[0] + o.at[1] * d.at[1],
                        o.at[0] * o.at[0] + o.at[1] * o.at[1] - r * r);
}

Stretch in_ball(const WidePoint& o, const WidePoint& d, double radius, double z) {
  WidePoint moved = o;
  moved.at[2] -= wide(z);
  const Wide r = wide(radius);
  return below_parabola(dot(d, d), dot(moved, d), Wide(dot(moved, moved) - r * r));
}

/// x^2 + y^2 <= (r w)^2 with w = (h - z) / 2 h, from 0 to 1. The set is convex, and the line's part
/// of the double cone is cut to one nappe first: there the form is q(s) <= 0 with 0 <= w(s) <= 1.
Stretch in_cone(const WidePoint& o, const WidePoint& d, double radius, double half) {
  const Wide r = wide(radius), h = wide(half);
  const Stretch slab = between(o.at[2], d.at[2], -h, h);
  if (!slab) return std::nullopt;
  const Wide wo = r * (h - o.at[2]) / (2 * h), wd = -r * d.at[2] / (2 * h);
  const Wide a = d.at[0] * d.at[0] + d.at[1] * d.at[1] - wd * wd;
  const Wide b = o.at[0] * d.at[0] + o.at[1] * d.at[1] - wo * wd;
  const Wide c = o.at[0] * o.at[0] + o.at[1] * o.at[1] - wo * wo;
  if (a > 0) return common(slab, below_parabola(a, b, c));
  if (a == 0) {
    if (b == 0) return c <= 0 ? slab : std::nullopt;
    const Wide s = -c / (2 * b);
    return common(slab, b > 0 ? WideStretch{-far_away(), s} : WideStretch{s, far_away()});
  }
  // Inside beyond either root, on different nappes: that with w >= 0 is ahead if w grows.
  const Wide discriminant = b * b - a * c;
  const Wide root = discriminant > 0 ? Wide(sqrt(discriminant)) : wide(0);
  const Wide first = (-b + root) / a, last = (-b - root) / a;
  return common(slab, wd > 0 ? WideStretch{last, far_away()} : WideStretch{-far_away(), first});
}

/// A point at (rho, z) and a convex polygon in that half plane.
template <std::size_t N>
double to_profile(double rho, double z, const std::array<std::array<double, 2>, N>& corner) {
  double least = HUGE_VAL;
  bool is_inside = true;
  for (std::size_t i = 0; i < N; ++i) {
    const auto& p = corner[i];
    const auto& q = corner[(i + 1) % N];
    const long double ex = q[0] - static_cast<long double>(p[0]);
    const long double ez = q[1] - static_cast<long double>(p[1]);
    const long double x = rho - static_cast<long double>(p[0]);
    const long double y = z - static_cast<long double>(p[1]);
    if (ex * y - ez * x < 0) is_inside = false;
    const long double square = ex * ex + ez * ez;
    const long double share =
        square > 0 ? std::clamp<long double>((x * ex + y * ez) / square, 0, 1) : 0;
    least = std::min(least, static_cast<double>(std::hypot(x - share * ex, y - share * ez)));
  }
  return is_inside ? 0 : least;
}

/// By the multiplier t of the nearest point x_k = a_k^2 p_k / (a_k^2 + t), found by halving.
double to_ellipsoid(const Vector3d& semi, const Vector3d& p) {
  long double ratio = 0;
  for (int k = 0; k < 3; ++k) {
    const long double share = static_cast<long double>(p[k]) / semi[k];
    ratio += share * share;
  }
  if (ratio <= 1) return 0;
  long double low = 0, high = 0;
  for (int k = 0; k < 3; ++k)
    high += std::abs(static_cast<long double>(p[k])) * semi[k];
  const auto is_outside = [&](long double t) {
    long double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const long double a = semi[k];
      const long double share = a * p[k] / (a * a + t);
      sum += share * share;
    }
    return sum > 1;
  };
  for (int i = 0; i < 3000 && high > 0; ++i) {
    const long double middle = low > 0 ? std::sqrt(low) * std::sqrt(high) : high * 0x1p-100L;
    if (low > 0 && (middle <= low || middle >= high)) break;
    (is_outside(middle) ? low : high) = middle;
  }
  long double square = 0;
  for (int k = 0; k < 3; ++k) {
    const long double a = semi[k];
    const long double off = high * p[k] / (a * a + high);
    square += off * off;
  }
  return static_cast<double>(std::sqrt(square));
}

WidePoint relative(const WidePoint& p, const Vector3d& centre) {
  WidePoint moved = p;
  for (std::size_t k = 0; k < 3; ++k)
    moved.at[k] -= wide(centre[static_cast<int>(k)]);
  return moved;
}

Vector3d rounded(const WidePoint& p) {
  return {p.at[0].get_d(), p.at[1].get_d(), p.at[2].get_d()};
}

}  // namespace

WidePoint point_into(const Pose& pose, const Vector3d& p) {
  return inverse_times(pose, relative(wide_point(p), pose.translation()));
}

WidePoint direction_into(const Pose& pose, const Vector3d& d) {
  return inverse_times(pose, wide_point(d));
}

std::optional<WideStretch> stretch_in(const Shape& shape, const WidePoint& o, const WidePoint& d) {
  if (const auto* s = shape.as<Sphere>())
    return in_ellipsoid(relative(o, s->centre), d, Vector3d::Constant(s->radius));
  if (const auto* s = shape.as<Ellipsoid>())
    return in_ellipsoid(relative(o, s->centre), d, s->semi_axes);
  if (const auto* s = shape.as<Box>()) {
    Stretch stretch = all();
    for (std::size_t k = 0; k < 3; ++k) {
      const Wide half = wide(s->half_extents[static_cast<int>(k)]);
      stretch = common(stretch, between(o.at[k], d.at[k], -half, half));
    }
    return stretch;
  }
  const auto slab = [&](double half) { return between(o.at[2], d.at[2], wide(-half), wide(half)); };
  if (const auto* s = shape.as<Cylinder>())
    return common(in_tube(o, d, s->radius), slab(s->half_height));
  if (const auto* s = shape.as<Cone>()) return in_cone(o, d, s->radius, s->half_height);
  const auto* s = shape.as<Capsule>();
  const Stretch ends =
      joined(in_ball(o, d, s->radius, s->half_length), in_ball(o, d, s->radius, -s->half_length));
  return joined(ends, common(in_tube(o, d, s->radius), slab(s->half_length)));
}

double distance_to(const Shape& shape, const WidePoint& point) {
  if (const auto* s = shape.as<Sphere>())
    return std::max(rounded(relative(point, s->centre)).stableNorm() - s->radius, 0.0);
  if (const auto* s = shape.as<Ellipsoid>())
    return to_ellipsoid(s->semi_axes, rounded(relative(point, s->centre)));
  const Vector3d p = rounded(point);
  const double rho = std::hypot(p.x(), p.y());
  if (const auto* s = shape.as<Box>())
    return (p.cwiseAbs() - s->half_extents).cwiseMax(0).stableNorm();
  if (const auto* s = shape.as<Cylinder>()) {
    return std::hypot(std::max(rho - s->radius, 0.0),
                      std::max(std::abs(p.z()) - s->half_height, 0.0));
  }
  if (const auto* s = shape.as<Cone>()) {
    const std::array<std::array<double, 2>, 3> profile{
        {{0, -s->half_height}, {s->radius, -s->half_height}, {0, s->half_height}}};
    return to_profile(rho, p.z(), profile);
  }
  const auto* s = shape.as<Capsule>();
  const double beyond = std::max(std::abs(p.z()) - s->half_length, 0.0);
  return std::max(std::hypot(rho, beyond) - s->radius, 0.0);
}

double reach_along(const Shape& shape, const Vector3d& n) {
  const double flat = std::hypot(n.x(), n.y());
  if (const auto* s = shape.as<Sphere>()) return n.dot(s->centre) + s->radius * n.norm();
  if (const auto* s = shape.as<Ellipsoid>())
    return n.dot(s->centre) + n.cwiseProduct(s->semi_axes).stableNorm();
  if (const auto* s = shape.as<Box>()) return n.cwiseAbs().dot(s->half_extents);
  if (const auto* s = shape.as<Cylinder>())
    return flat * s->radius + std::abs(n.z()) * s->half_height;
  if (const auto* s = shape.as<Cone>())
    return std::max(n.z() * s->half_height, flat * s->radius - n.z() * s->half_height);
  const auto* s = shape.as<Capsule>();
  return std::abs(n.z()) * s->half_length + s->radius * n.norm();
}

}  // namespace graze::tests
