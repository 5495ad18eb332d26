#include <graze/engine/mesh/health/volume_sign.h>
#include <graze/narrowphase/predicates/exact_vector.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace graze {
namespace {

using narrowphase::BigInteger;
using narrowphase::BigVector;
using narrowphase::CommonUnit;
using narrowphase::Sign;

constexpr double kUnitRoundoff = 0x1p-53;

// The bound holds for sums of sizes below this: no product of three differences has overflowed.
constexpr double kLargest = 0x1p+1000;

/// Returns the sign of six times the volume, if rounding leaves it sure. The volume is a sum of
/// determinants about a corner, each of six products of three differences. A product carries at
/// most eight roundings, of three differences, two products, one subtraction and two sums, so that
/// a determinant of n is off by at most 8.01 u times the sum of its products' sizes, and the sum of
/// n of them by another (n - 1) 1.01 u times that. The sizes themselves are short by at most 9
/// roundings each and n for their sum; 2 (n + 8) u covers all, for n u is below 2^-21. Underflow
/// takes half of the least double from each of six products of two, which are then multiplied by a
/// difference, and from three more: for each triangle less than 6 |the largest difference| + 3 of
/// these, and from the bound itself one; 8 and 8 cover it.
std::optional<Sign> rounded_sign(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
  const Eigen::Vector3d origin = mesh.triangle(triangles.front()).a;
  double sum = 0;
  double sizes = 0;
  double largest = 0;
  for (const std::uint32_t index : triangles) {
    const Triangle triangle = mesh.triangle(index);
    const Eigen::Vector3d a = triangle.a - origin;
    const Eigen::Vector3d b = triangle.b - origin;
    const Eigen::Vector3d c = triangle.c - origin;
    largest = std::max(
        {largest, a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff()});
    sum += a.x() * (b.y() * c.z() - b.z() * c.y()) + a.y() * (b.z() * c.x() - b.x() * c.z()) +
           a.z() * (b.x() * c.y() - b.y() * c.x());
    sizes += std::abs(a.x()) * (std::abs(b.y() * c.z()) + std::abs(b.z() * c.y())) +
             std::abs(a.y()) * (std::abs(b.z() * c.x()) + std::abs(b.x() * c.z())) +
             std::abs(a.z()) * (std::abs(b.x() * c.y()) + std::abs(b.y() * c.x()));
  }
  if (!(sizes <= kLargest)) return std::nullopt;
  const auto count = static_cast<double>(triangles.size());
  const double underflow = count * (8 * largest + 8) * std::numeric_limits<double>::denorm_min();
  const double bound = 2 * (count + 8) * kUnitRoundoff * sizes + underflow;
  if (sum > bound) return Sign::Positive;
  if (sum < -bound) return Sign::Negative;
  return std::nullopt;
}

Sign exact_sign(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
  CommonUnit unit({0.0});
  for (const std::uint32_t index : triangles) {
    for (const std::uint32_t vertex : mesh.triangles()[index])
      unit.include(mesh.vertices()[vertex].data(), 3);
  }
  const Eigen::Vector3d origin = mesh.triangle(triangles.front()).a;
  BigInteger sum;
  for (const std::uint32_t index : triangles) {
    const Triangle triangle = mesh.triangle(index);
    const auto from_origin = [&](const Eigen::Vector3d& corner) {
      return BigVector::difference(corner.data(), origin.data(), unit);
    };
    sum =
        sum + dot(from_origin(triangle.a), cross(from_origin(triangle.b), from_origin(triangle.c)));
  }
  return sum.sign();
}

}  // namespace

Sign volume_sign(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
  const std::optional<Sign> sign = rounded_sign(mesh, triangles);
  return sign ? *sign : exact_sign(mesh, triangles);
}

}  // namespace graze
