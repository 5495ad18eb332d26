#pragma once

// B moves along a direction d and A stays: at how large a translation can they still meet, and from
// how small a one on? Weak duality answers, rigorously: if p of A meets q of B moved by s d, then
// p - q = s d, and for every vector n at all s (n.d) = n.(p - q), which is at most the largest
// n.(p - q) there is. So each n bounds s, whatever its own rounding, and a few well chosen ones
// bound it tightly.

#include <graze/bvh/obb.h>
#include <graze/bvh/sphere.h>
#include <graze/engine/mesh/placed_mesh.h>

#include <limits>

namespace graze::contacts {

inline constexpr double kUnitRoundoff = 0x1p-53;

/// The units in which a sweep is measured: coordinates times `per_metre`, a power of two, are below
/// 1 in size.
struct SweepUnits {
  SweepUnits(const PlacedMeshView& a, const PlacedMeshView& b);
  SweepUnits(const PlacedMeshView& a, const Aabb& b);
  SweepUnits(const PlacedMeshView& a, const Sphere& b);
  /// Bounds coordinates in the frame of the box, too (law 3).
  SweepUnits(const PlacedMeshView& a, const Obb& b);

  double per_metre;
  double metres;  ///< the length of one unit

 private:
  explicit SweepUnits(double quarter);
};

/// True if a vector is so large that products with it cannot underflow; smaller ones say nothing.
inline bool says_something(double size_of_n) {
  return size_of_n >= 0x1p-400;
}

/// The factors by which bounds of n.(p - q) are multiplied to bound the translation, for n.d =
/// `along` >= 0 and `size`, the sum of the absolute components of n; no component of d is above 1
/// in size.
struct SweepScale {
  SweepScale(double along, double size);

  double across;  ///< not negative if n is hardly along the motion: n.(p - q) must be 0 to this,
                  ///< for |d| = 1
  double up;      ///< else the factor of an upper bound that is not negative
  double down;    ///< and that of a lower bound that is positive
};

/// The translations, 0 and more, that some vectors n leave possible.
class SweepBounds {
 public:
  /// Takes the margin, by which each coordinate of p - q may be off.
  explicit SweepBounds(double margin) : margin_(margin) {}

  /// Takes note of one n: `along` is n.d, `size` the sum of its absolute components, and `lowest`
  /// and `highest` are of n.(p - q). The bounds hold for any n; one with no size says nothing.
  void note(double along, double size, double lowest, double highest);

  bool is_empty() const { return lower_ > upper_; }
  double upper() const { return upper_; }

 private:
  double margin_;
  double lower_ = 0;
  double upper_ = std::numeric_limits<double>::infinity();
};

/// Returns the middle of the mesh's own bounds, placed.
Eigen::Vector3d middle_of(const PlacedMeshView& placed);

}  // namespace graze::contacts
