#include <graze/engine/compare/judge/rational/sure_pair.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace graze::compare {
namespace {

using Eigen::Vector3d;

/// Holds a number and how far the real one may be from it. A rounded sum or product is off by up to
/// 2^-53 of itself, but for a product that underflows, which is off by less than kLeast; the seven
/// roundings of the bound itself are less than kUp - 1 of it, or less than kLeast again. A number
/// that overflows has an infinite bound, or NaN for one, and no sign.
struct Near {
  double value = 0;
  double error = 0;

  /// Returns 1 or -1 if the real number surely has that sign, else 0.
  int sign() const { return value > error ? 1 : value < -error ? -1 : 0; }
};

constexpr double kUnit = 0x1p-53;
constexpr double kUp = 1 + 0x1p-50;
constexpr double kLeast = 0x1p-1000;

Near bounded(double value, double error) {
  return {value, (error + kUnit * std::abs(value)) * kUp + kLeast};
}

Near operator+(const Near& a, const Near& b) {
  return bounded(a.value + b.value, a.error + b.error);
}

Near operator-(const Near& a, const Near& b) {
  return bounded(a.value - b.value, a.error + b.error);
}

Near operator*(const Near& a, const Near& b) {
  return bounded(a.value * b.value,
                 (std::abs(a.value) + a.error) * b.error + std::abs(b.value) * a.error);
}

using NearVector = std::array<Near, 3>;

NearVector difference(const Vector3d& p, const Vector3d& q) {
  return {Near{p.x()} - Near{q.x()}, Near{p.y()} - Near{q.y()}, Near{p.z()} - Near{q.z()}};
}

NearVector near_cross(const NearVector& p, const NearVector& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

Near near_dot(const NearVector& p, const NearVector& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

using Corners = std::array<Vector3d, 3>;

Corners corners_of(const Triangle& t) {
  return {t.a, t.b, t.c};
}

/// Returns on which side of the plane of a triangle the corners of another surely lie.
std::array<int, 3> sides(const Corners& plane, const Corners& corners) {
  const NearVector normal =
      near_cross(difference(plane[1], plane[0]), difference(plane[2], plane[0]));
  std::array<int, 3> result{};
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = near_dot(normal, difference(corners[i], plane[0])).sign();
  return result;
}

/// True if the line through two points surely passes within the sides of a triangle: it has them
/// all on one hand.
bool passes_within(const Vector3d& from, const Vector3d& to, const Corners& triangle) {
  const NearVector along = difference(to, from);
  std::array<NearVector, 3> corner;
  for (std::size_t i = 0; i < 3; ++i)
    corner[i] = difference(triangle[i], from);
  int hand = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const int sign = near_dot(along, near_cross(corner[i], corner[(i + 1) % 3])).sign();
    if (sign == 0 || sign == -hand) return false;
    hand = sign;
  }
  return true;
}

bool has_edge_through(const Corners& edges, const std::array<int, 3>& side, const Corners& plane) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if (side[i] * side[next] == -1 && passes_within(edges[i], edges[next], plane)) return true;
  }
  return false;
}

/// True if the axis seems to part the two, in plain doubles, which proves nothing.
bool seems_to_part(const Vector3d& axis, const Corners& a, const Corners& b) {
  double most_a = 0;  // the most from a's first corner on
  double least_a = 0;
  double most_b = -std::numeric_limits<double>::infinity();
  double least_b = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const double in_a = axis.dot(a[i] - a[0]);
    const double in_b = axis.dot(b[i] - a[0]);
    most_a = std::max(most_a, in_a);
    least_a = std::min(least_a, in_a);
    most_b = std::max(most_b, in_b);
    least_b = std::min(least_b, in_b);
  }
  return least_b > most_a || least_a > most_b;
}

/// True if every corner of B surely lies beyond every corner of A along the axis, or before it.
bool surely_parts(const Vector3d& axis, const Corners& a, const Corners& b) {
  const NearVector along = {Near{axis.x()}, Near{axis.y()}, Near{axis.z()}};
  std::array<Near, 3> in_a;
  std::array<Near, 3> in_b;
  for (std::size_t i = 0; i < 3; ++i) {
    in_a[i] = near_dot(along, difference(a[i], a[0]));
    in_b[i] = near_dot(along, difference(b[i], a[0]));
  }
  const int side = (in_b[0] - in_a[0]).sign();
  if (side == 0) return false;
  for (const Near& p : in_a) {
    for (const Near& q : in_b)
      if ((q - p).sign() != side) return false;
  }
  return true;
}

/// Proves it by a normal, or an axis across an edge of each: one of them parts triangles that are
/// apart.
bool are_surely_apart(const Corners& a, const Corners& b) {
  const std::array<Vector3d, 3> edges_a = {a[1] - a[0], a[2] - a[1], a[0] - a[2]};
  const std::array<Vector3d, 3> edges_b = {b[1] - b[0], b[2] - b[1], b[0] - b[2]};
  const auto parts = [&](const Vector3d& axis) {
    return seems_to_part(axis, a, b) && surely_parts(axis, a, b);
  };
  if (parts(edges_a[0].cross(edges_a[1])) || parts(edges_b[0].cross(edges_b[1]))) return true;
  for (const Vector3d& p : edges_a) {
    for (const Vector3d& q : edges_b)
      if (parts(p.cross(q))) return true;
  }
  return false;
}

}  // namespace

std::optional<bool> surely_intersects(const Triangle& triangle_a, const Triangle& triangle_b) {
  const Corners a = corners_of(triangle_a);
  const Corners b = corners_of(triangle_b);
  if (are_surely_apart(a, b)) return false;
  if (has_edge_through(b, sides(a, b), a) || has_edge_through(a, sides(b, a), b)) return true;
  return std::nullopt;
}

bool lies_surely_beyond(const Triangle& triangle_a, const Triangle& triangle_b,
                        const Vector3d& along, double distance) {
  const Corners a = corners_of(triangle_a);
  const Corners b = corners_of(triangle_b);
  const NearVector axis = {Near{along.x()}, Near{along.y()}, Near{along.z()}};
  // This is above the product in real numbers: the root of a sum of three squares, and two
  // products.
  const double beyond = along.stableNorm() * distance * (1 + 0x1p-48);
  if (!(beyond > kLeast)) return false;
  for (const Vector3d& p : a) {
    for (const Vector3d& q : b) {
      const Near gap = near_dot(axis, difference(q, p)) - Near{beyond};
      if (gap.sign() != 1) return false;
    }
  }
  return true;
}

}  // namespace graze::compare
