#include <graze/narrowphase/predicates/fixed_point.h>
#include <algorithm>
#include <bit>
#include <cmath>

namespace graze::narrowphase {
namespace {

constexpr int kBits = 60;

// From here up, the unit and its inverse are powers of two in the range of normal doubles. Smaller
// numbers are taken larger first, which is exact for all of them.
constexpr double kSmallest = 0x1p-900;
constexpr double kEnlargement = 0x1p+200;

double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// The exponent e of a normal number: 2^e <= value < 2^(e + 1).
int exponent_of(double value) {
  return static_cast<int>(std::bit_cast<std::uint64_t>(value) >> 52) - 1023;
}

bool to_fixed_axis(const double* const* points, int count, int axis, FixedPoint* fixed) {
  double largest = 0;
  for (int i = 0; i < count; ++i)
    largest = std::max(largest, std::abs(points[i][axis]));
  if (largest == 0) {
    for (int i = 0; i < count; ++i)
      fixed[i][axis] = 0;
    return true;
  }
  const double enlargement = largest < kSmallest ? kEnlargement : 1;
  largest *= enlargement;
  const int unit = exponent_of(largest) + 1 - kBits;
  const double scale = power_of_two(-unit);
  const double inverse = power_of_two(unit);
  bool is_exact = true;
  for (int i = 0; i < count; ++i) {
    // A value that conversion and back does not restore is no integer, or underflows.
    const double value = points[i][axis] * enlargement;
    const auto integer = static_cast<std::int64_t>(value * scale);
    is_exact &= static_cast<double>(integer) * inverse == value;
    fixed[i][axis] = integer;
  }
  return is_exact;
}

}  // namespace

bool to_fixed_point(const double* const* points, int count, FixedPoint* fixed) {
  return to_fixed_axis(points, count, 0, fixed) && to_fixed_axis(points, count, 1, fixed) &&
         to_fixed_axis(points, count, 2, fixed);
}

PlaneSides sides_of_plane(const Corners<double>& plane, const Corners<double>& other) {
  PlaneSides sides;
  for (int i = 0; i < 3; ++i) {
    sides.sign[i] = orientation_3d(plane.point[0], plane.point[1], plane.point[2], other.point[i]);
  }
  return sides;
}

PlaneSides sides_of_plane(const Corners<std::int64_t>& plane, const Corners<std::int64_t>& other) {
  const FixedNormal normal = normal_of(plane.point[0], plane.point[1], plane.point[2]);
  PlaneSides sides;
  for (int i = 0; i < 3; ++i)
    sides.sign[i] = side_of(normal, plane.point[0], other.point[i]);
  return sides;
}

/// Of the axes along which the projection has area the one with the largest, as it is rounded:
/// there the filters of orientations are most often sure.
int projection_axis(const Corners<double>& triangle) {
  int best = -1;
  double best_area = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const Point2 a = project(triangle.point[0], axis);
    const Point2 b = project(triangle.point[1], axis);
    const Point2 c = project(triangle.point[2], axis);
    if (orientation_2d(a, b, c) == Sign::Zero) continue;
    const double area = std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    if (best < 0 || area > best_area) {
      best = axis;
      best_area = area;
    }
  }
  return best;
}

int projection_axis(const Corners<std::int64_t>& triangle) {
  const FixedNormal normal = normal_of(triangle.point[0], triangle.point[1], triangle.point[2]);
  if (normal.x != 0) return 0;
  if (normal.y != 0) return 1;
  return normal.z != 0 ? 2 : -1;
}

}  // namespace graze::narrowphase
