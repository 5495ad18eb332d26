#include <graze/bvh/error.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/sweep/sweep.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace graze::contacts {
namespace {

constexpr int kSmallestExponent = -1000;  // so that its inverse is a double, too

/// Returns a quarter of what bounds the absolute value of each placed coordinate: so sums cannot
/// overflow.
double quarter_of_largest(const PlacedMeshView& placed) {
  double largest = 0;
  for (double coordinate : largest_coordinates(placed.pose, placed.mesh.bounds()))
    largest = std::max(largest, 0.25 * coordinate);
  return largest;
}

double quarter_of_largest(const Aabb& box) {
  double largest = 0;
  for (int k = 0; k < 3; ++k) {
    largest = std::max(largest, std::abs(0.25 * box.min.data()[k]));
    largest = std::max(largest, std::abs(0.25 * box.max.data()[k]));
  }
  return largest;
}

double quarter_of_largest(const Sphere& ball) {
  double largest = 0;
  for (int k = 0; k < 3; ++k)
    largest = std::max(largest, std::abs(0.25 * ball.centre.data()[k]));
  return largest + 0.25 * ball.radius;
}

/// Returns the same for each coordinate that is taken into a frame: the sums are in the order of
/// law 3, and rounding is monotone.
double quarter_of_largest(const PlacedMeshView& placed, const Pose& frame) {
  const double* m = frame.data();  // column-major 4x4: column i is the frame's axis i
  std::array<double, 3> coordinates = largest_coordinates(placed.pose, placed.mesh.bounds());
  double largest = 0;
  for (int k = 0; k < 3; ++k) {
    coordinates[k] = 0.25 * coordinates[k] + 0.25 * std::abs(m[12 + k]);
    largest = std::max(largest, coordinates[k]);
  }
  for (int i = 0; i < 3; ++i) {
    const double* axis = m + 4 * i;
    const double coordinate =
        (std::abs(axis[0]) * coordinates[0] + std::abs(axis[1]) * coordinates[1]) +
        std::abs(axis[2]) * coordinates[2];
    largest = std::max(largest, coordinate);
  }
  return largest;
}

// The error of n.d: as the components of d are at most 1 in size and exact, 4 u of the size of n
// cover three roundings.
constexpr double kAlongBound = 4 * kUnitRoundoff;

// A vector that is noted as across has n.d up to 8 u, off by 4 u. While triangles meet, s |d| = |p
// - q| is below 2 sqrt(3) < 4, so that s (n.d) is below 48 u for |d| = 1.
constexpr double kAcrossBound = 48 * kUnitRoundoff;

// These cover the product with an inverse of positive numbers: the difference, the inverse and the
// product round.
constexpr double kUp = 1 + 8 * kUnitRoundoff;
constexpr double kDown = 1 - 8 * kUnitRoundoff;

}  // namespace

SweepUnits::SweepUnits(const PlacedMeshView& a, const PlacedMeshView& b)
    : SweepUnits(quarter_of_largest(a) + quarter_of_largest(b)) {}

SweepUnits::SweepUnits(const PlacedMeshView& a, const Aabb& b)
    : SweepUnits(quarter_of_largest(a) + quarter_of_largest(b)) {}

SweepUnits::SweepUnits(const PlacedMeshView& a, const Sphere& b)
    : SweepUnits(quarter_of_largest(a) + quarter_of_largest(b)) {}

SweepUnits::SweepUnits(const PlacedMeshView& a, const Obb& b)
    : SweepUnits(quarter_of_largest(a, b.pose) +
                 quarter_of_largest(Aabb{-b.half_extents, b.half_extents})) {}

SweepUnits::SweepUnits(double quarter) {
  int exponent = kSmallestExponent;
  if (quarter > 0) exponent = std::max(std::ilogb(quarter) + 3, exponent);
  if (exponent > 1023) throw PoseError("sweep of B: its coordinates could overflow");
  metres = std::ldexp(1.0, exponent);
  per_metre = 1 / metres;
}

SweepScale::SweepScale(double along, double size) : across(-1), up(0), down(0) {
  if (along <= 2 * kAlongBound * size) {
    // If n is across the motion, n.(p - q) hardly changes: it must be able to be zero.
    across = kAcrossBound * size;
    return;
  }
  up = kUp / (along - kAlongBound * size);
  down = kDown / (along + kAlongBound * size);
}

void SweepBounds::note(double along, double size, double lowest, double highest) {
  if (!says_something(size)) return;
  if (along < 0) {
    along = -along;
    std::swap(lowest, highest);
    lowest = -lowest;
    highest = -highest;
  }
  const double low = lowest - margin_ * size;
  const double high = highest + margin_ * size;
  const SweepScale scale(along, size);
  if (scale.across >= 0) {
    if (high < -scale.across || low > scale.across) upper_ = -1;
    return;
  }
  upper_ = high < 0 ? -1 : std::min(upper_, high * scale.up);
  if (low > 0) lower_ = std::max(lower_, low * scale.down);
}

Eigen::Vector3d middle_of(const PlacedMeshView& placed) {
  const Aabb& box = placed.mesh.bounds();
  Eigen::Vector3d middle;
  for (int k = 0; k < 3; ++k)
    middle.data()[k] = 0.5 * box.min.data()[k] + 0.5 * box.max.data()[k];
  return narrowphase::place(placed.pose, middle);
}

}  // namespace graze::contacts
