#include <tests/fuzz/byte_shapes.h>
#include <Eigen/Geometry>
#include <bit>
#include <cmath>

namespace graze::fuzz {

using Eigen::Vector3d;

std::uint8_t ByteShapes::byte() {
  if (bytes_.empty()) return 0;
  const std::uint8_t value = bytes_.front();
  bytes_ = bytes_.subspan(1);
  return value;
}

// Infinity and NaN lose a bit of their exponent.
double ByteShapes::any_double() {
  std::uint64_t bits = 0;
  for (int i = 0; i < 8; ++i)
    bits = bits << 8 | byte();
  const double value = std::bit_cast<double>(bits);
  return std::isfinite(value) ? value : std::bit_cast<double>(bits & ~(std::uint64_t{1} << 62));
}

double ByteShapes::neighbour(double value) {
  const int steps = byte() % 7 - 3;
  for (int i = 0; i < std::abs(steps); ++i) {
    const double next = std::nextafter(value, steps < 0 ? -HUGE_VAL : HUGE_VAL);
    if (std::isfinite(next)) value = next;
  }
  return value;
}

double ByteShapes::coordinate() {
  const int choice = byte();
  double value = choice / 4 % 7 - 3;
  if (choice % 4 == 1 && !coordinates_.empty()) {
    value = neighbour(coordinates_[static_cast<std::size_t>(choice / 4) % coordinates_.size()]);
  } else if (choice % 4 == 2) {
    value = any_double();
  } else if (choice % 4 == 3) {
    value += byte() / 256.0;
    value = std::ldexp(value, byte() % 64 - 32);
  }
  coordinates_.push_back(value);
  return value;
}

const Vector3d& ByteShapes::earlier_point() {
  return points_[byte() % points_.size()];
}

Vector3d ByteShapes::fresh_point() {
  return Vector3d{coordinate(), coordinate(), coordinate()};
}

// Half the points between two earlier ones, with rounding; halved first, so that nothing overflows.
Vector3d ByteShapes::combined_point() {
  const Vector3d p = earlier_point();
  const Vector3d q = earlier_point();
  const Vector3d r = earlier_point();
  switch (byte() % 4) {
    case 0:
      return p;
    case 1:
      return 0.5 * p + 0.5 * q;
    case 2: {
      const Vector3d corner = p + (q - r);
      return corner.allFinite() ? corner : p;
    }
    default:
      return {neighbour(p.x()), neighbour(p.y()), neighbour(p.z())};
  }
}

Vector3d ByteShapes::point() {
  const bool is_combined = byte() % 2 == 1 && !points_.empty();
  points_.push_back(is_combined ? combined_point() : fresh_point());
  return points_.back();
}

Triangle ByteShapes::triangle() {
  return {point(), point(), point()};
}

Aabb ByteShapes::box() {
  const Vector3d p = point();
  const Vector3d q = point();
  return {p.cwiseMin(q), p.cwiseMax(q)};
}

// A quaternion of small integers gives turns by right angles as well as slanted ones. What is off
// stays within the 1e-6 that law 10 allows, or is refused.
Pose ByteShapes::pose() {
  Pose pose = Pose::Identity();
  const int choice = byte();
  if (choice % 4 != 0) {
    double q[4];
    double square = 0;
    for (double& component : q) {
      component = byte() % 9 - 4;
      square += component * component;
    }
    if (square > 0)
      pose.linear() = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
  }
  for (int k = 0; k < 9 && choice % 4 > 1; ++k) {
    double& entry = pose.matrix()(k / 3, k % 3);
    entry = choice % 4 == 2 ? neighbour(entry) : entry + (byte() - 128) * 0x1p-29;
  }
  pose.translation() = point();
  return pose;
}

}  // namespace graze::fuzz
