#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/sphere.h>
#include <graze/narrowphase/triangle.h>

#include <cmath>
#include <initializer_list>

#include "tests/shapes/random_source.h"

namespace graze {

/// Kinds of numbers that volumes are made of. Extreme ones are the smallest, the largest and few in
/// between: exact arithmetic needs all of its width for these.
enum class Numbers { Generic, Lattice, MixedScale, Denormal, Huge, Extreme };

inline constexpr Numbers kEveryKind[] = {Numbers::Generic,  Numbers::Lattice, Numbers::MixedScale,
                                         Numbers::Denormal, Numbers::Huge,    Numbers::Extreme};

/// Integer vectors whose length is an integer.
struct Quadruple {
  Eigen::Vector3d way;
  double length;
};

/// Random volumes of one kind of number; those of a lattice often touch exactly.
class VolumeSource {
 public:
  VolumeSource(Numbers kind, std::uint64_t seed) : kind_(kind), random_(seed) {}

  RandomSource& random() { return random_; }

  double coordinate() {
    switch (kind_) {
      case Numbers::Generic:
        return random_.uniform(-1, 1);
      case Numbers::Lattice:
        return random_.integer(-3, 3);
      case Numbers::MixedScale: {
        const int exponent = static_cast<int>(random_.integer(-996, 996));
        return std::ldexp(random_.uniform(-1, 1), exponent);
      }
      case Numbers::Denormal:
        return random_.integer(-9, 9) * 0x1p-1074;
      case Numbers::Huge:
        return random_.uniform(-1, 1) * 0x1.fffffffffffffp1023;
      case Numbers::Extreme:
        return extreme();
    }
    return 0;
  }

  /// Not negative.
  double size() { return std::abs(coordinate()); }

  Eigen::Vector3d point() {
    const double x = coordinate();
    const double y = coordinate();
    return {x, y, coordinate()};
  }

  Sphere sphere() {
    const Eigen::Vector3d centre = point();
    return {centre, size()};
  }

  Aabb box() {
    const Eigen::Vector3d p = point();
    const Eigen::Vector3d q = point();
    return {p.cwiseMin(q), p.cwiseMax(q)};
  }

  Triangle triangle() {
    const Eigen::Vector3d a = point();
    const Eigen::Vector3d b = point();
    return {a, b, point()};
  }

  /// At random among some, with components swapped and negated.
  Quadruple quadruple() {
    static constexpr double kLengths[][4] = {
        {1, 2, 2, 3},  {2, 3, 6, 7}, {1, 4, 8, 9},   {4, 4, 7, 9},   {2, 6, 9, 11},
        {6, 6, 7, 11}, {0, 3, 4, 5}, {3, 4, 12, 13}, {2, 5, 14, 15}, {0, 5, 12, 13}};
    const double* chosen = kLengths[static_cast<int>(random_.integer(0, 9))];
    const int turn = static_cast<int>(random_.integer(0, 2));
    Quadruple result;
    for (int i = 0; i < 3; ++i)
      result.way[i] = chosen[(i + turn) % 3] * (random_.integer(0, 1) == 0 ? 1 : -1);
    result.length = chosen[3];
    return result;
  }

 private:
  double extreme() {
    static constexpr double kSizes[] = {0, 0x1p-1074, 0x1.8p-1022,
                                        1, 0x1p1023,  0x1.fffffffffffffp1023};
    const double size = kSizes[static_cast<int>(random_.integer(0, 5))];
    return random_.integer(0, 1) == 0 ? size : -size;
  }

  Numbers kind_;
  RandomSource random_;
};

/// One step away from 0, and one towards it, from a positive number.
inline double next_above(double value) {
  return std::nextafter(value, HUGE_VAL);
}
inline double next_below(double value) {
  return std::nextafter(value, 0.0);
}

}  // namespace graze
