#include <graze/engine/scenes/path/turn.h>

#include <array>
#include <cmath>

namespace graze::scenes {
namespace {

Quaternion unit(const Quaternion& q) {
  const double length = std::sqrt(((q.w * q.w + q.x * q.x) + q.y * q.y) + q.z * q.z);
  return {q.w / length, q.x / length, q.y / length, q.z / length};
}

Quaternion sum(const Quaternion& a, const Quaternion& b) {
  return {a.w + b.w, a.x + b.x, a.y + b.y, a.z + b.z};
}

/// Returns a quaternion on an arc of at most half a circle. Each halving adds at most an ulp or
/// two.
Quaternion on_arc(Quaternion a, Quaternion b, double fraction) {
  // The chord is as good as the arc once the cube of the angle is below the last bit: an angle of
  // at most pi after 20 halvings is below 2^-18.
  constexpr int kHalvings = 20;
  for (int i = 0; i < kHalvings && fraction > 0 && fraction < 1; ++i) {
    const Quaternion middle = unit(sum(a, b));
    fraction *= 2;  // exact, and so is the difference
    if (fraction >= 1) {
      fraction -= 1;
      a = middle;
    } else {
      b = middle;
    }
  }
  if (fraction == 0) return a;
  if (fraction == 1) return b;
  return unit({a.w + (b.w - a.w) * fraction, a.x + (b.x - a.x) * fraction,
               a.y + (b.y - a.y) * fraction, a.z + (b.z - a.z) * fraction});
}

}  // namespace

Quaternion turned_by(const Eigen::Vector3d& axis, double turns) {
  double quarters = 4 * (turns - std::floor(turns));
  if (!(quarters < 4)) quarters = 0;  // a tiny way before a full turn, rounded to it
  const int whole = static_cast<int>(quarters);
  // These are the half angles 0, 45, 90, 135 and 180 degrees.
  const double diagonal = std::sqrt(0.5);
  constexpr int kCount = 5;
  const std::array<double, kCount> cosines = {1, diagonal, 0, -diagonal, -1};
  const std::array<double, kCount> sines = {0, diagonal, 1, diagonal, 0};
  const auto at = [&](int quarter) -> Quaternion {
    const auto i = static_cast<std::size_t>(quarter);
    return {cosines[i], sines[i] * axis.x(), sines[i] * axis.y(), sines[i] * axis.z()};
  };
  return on_arc(at(whole), at(whole + 1), quarters - whole);
}

Quaternion between(const Quaternion& a, Quaternion b, double fraction) {
  const double cosine = ((a.w * b.w + a.x * b.x) + a.y * b.y) + a.z * b.z;
  if (cosine < 0) b = {-b.w, -b.x, -b.y, -b.z};  // q and -q are one rotation
  return on_arc(a, b, fraction);
}

// Each of 4w^2, 4x^2, 4y^2 and 4z^2 is a sum of the diagonal; the largest of them is at least 1, so
// that its root and the quotients by it lose nothing (Shepperd 1978).
Quaternion quaternion_of(const Eigen::Matrix3d& r) {
  const double xx = r(0, 0), yy = r(1, 1), zz = r(2, 2);
  const std::array<double, 4> squares = {((1 + xx) + yy) + zz, ((1 + xx) - yy) - zz,
                                         ((1 - xx) + yy) - zz, ((1 - xx) - yy) + zz};
  std::size_t largest = 0;
  for (std::size_t i = 1; i < squares.size(); ++i)
    if (squares[i] > squares[largest]) largest = i;
  const double wx = r(2, 1) - r(1, 2), wy = r(0, 2) - r(2, 0), wz = r(1, 0) - r(0, 1);
  const double xy = r(1, 0) + r(0, 1), xz = r(2, 0) + r(0, 2), yz = r(2, 1) + r(1, 2);
  switch (largest) {
    case 0:
      return unit({squares[0], wx, wy, wz});
    case 1:
      return unit({wx, squares[1], xy, xz});
    case 2:
      return unit({wy, xy, squares[2], yz});
    default:
      return unit({wz, xz, yz, squares[3]});
  }
}

Eigen::Matrix3d matrix_of(const Quaternion& q) {
  const double xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const double xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
  const double wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  Eigen::Matrix3d r;
  r(0, 0) = 1 - 2 * (yy + zz);
  r(0, 1) = 2 * (xy - wz);
  r(0, 2) = 2 * (xz + wy);
  r(1, 0) = 2 * (xy + wz);
  r(1, 1) = 1 - 2 * (xx + zz);
  r(1, 2) = 2 * (yz - wx);
  r(2, 0) = 2 * (xz - wy);
  r(2, 1) = 2 * (yz + wx);
  r(2, 2) = 1 - 2 * (xx + yy);
  return r;
}

Eigen::Matrix3d product(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  Eigen::Matrix3d result;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      result(row, column) =
          (a(row, 0) * b(0, column) + a(row, 1) * b(1, column)) + a(row, 2) * b(2, column);
    }
  }
  return result;
}

}  // namespace graze::scenes
