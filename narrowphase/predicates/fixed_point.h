#pragma once

// Finds orientations of points whose coordinates are integers of 60 bits, exactly and by plain
// integer arithmetic, without stages or branches. Most hard input is of that kind once its unit is
// taken out: lattices, floats, and doubles of similar size, for a double has but 53 bits. Each axis
// has a unit of its own: scaling an axis by a positive factor changes no sign of an orientation,
// nor the order of coordinates.

#include <graze/narrowphase/predicates/predicates.h>
#include <cstdint>

namespace graze::narrowphase {

__extension__ typedef __int128 Int128;

/// Coordinates of a point, of absolute values below 2^60, so that differences are below 2^61.
using FixedPoint = std::int64_t[3];

/// Writes `count` points as integers in units that are powers of two, one for each axis. If they
/// need more than 60 bits it returns false and leaves `fixed` unspecified. Coordinates must be
/// finite.
bool to_fixed_point(const double* const* points, int count, FixedPoint* fixed);

struct FixedPoint2 {
  std::int64_t x;
  std::int64_t y;
};

inline FixedPoint2 project(const std::int64_t* point, int axis) {
  return {point[(axis + 1) % 3], point[(axis + 2) % 3]};
}

inline Sign sign_of(Int128 value) {
  return static_cast<Sign>((value > 0) - (value < 0));
}

/// Returns (b - a) x (c - a), whose sign is orientation_2d(). The products are below 2^122.
inline Int128 area(FixedPoint2 a, FixedPoint2 b, FixedPoint2 c) {
  return static_cast<Int128>(b.x - a.x) * (c.y - a.y) -
         static_cast<Int128>(b.y - a.y) * (c.x - a.x);
}

inline Sign orientation_2d(FixedPoint2 a, FixedPoint2 b, FixedPoint2 c) {
  return sign_of(area(a, b, c));
}

/// A normal of the plane through three points: its components are below 2^123.
struct FixedNormal {
  Int128 x;
  Int128 y;
  Int128 z;
};

inline FixedNormal normal_of(const std::int64_t* a, const std::int64_t* b, const std::int64_t* c) {
  return {area(project(a, 0), project(b, 0), project(c, 0)),
          area(project(a, 1), project(b, 1), project(c, 1)),
          area(project(a, 2), project(b, 2), project(c, 2))};
}

/// The integer high 2^64 + low, in two parts that may overlap.
struct WideInteger {
  Int128 high;
  Int128 low;
};

/// Multiplies a below 2^123 by b below 2^61: the parts are below 2^120 and 2^125.
inline WideInteger wide_product(Int128 a, std::int64_t b) {
  return {(a >> 64) * b, static_cast<Int128>(static_cast<std::uint64_t>(a)) * b};
}

/// Returns the sign of normal . (d - a). The sums of three parts are below 2^122 and 2^127.
inline Sign side_of(const FixedNormal& normal, const std::int64_t* a, const std::int64_t* d) {
  const WideInteger x = wide_product(normal.x, d[0] - a[0]);
  const WideInteger y = wide_product(normal.y, d[1] - a[1]);
  const WideInteger z = wide_product(normal.z, d[2] - a[2]);
  const Int128 low = x.low + y.low + z.low;
  const Int128 high = x.high + y.high + z.high + (low >> 64);
  if (high != 0) return sign_of(high);
  return static_cast<std::uint64_t>(low) != 0 ? Sign::Positive : Sign::Zero;
}

inline Sign orientation_3d(const std::int64_t* a, const std::int64_t* b, const std::int64_t* c,
                           const std::int64_t* d) {
  return side_of(normal_of(a, b, c), a, d);
}

}  // namespace graze::narrowphase
