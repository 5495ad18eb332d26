#pragma once

// Finds where a ray goes through a face that it meets for sure. Private.

namespace graze::narrowphase {

// n . v is a sum of six products of three differences, each at most the product of the sizes, and
// goes through at most 8 operations of kPairRoundoff: off by less than 2^-95 of that product. Above
// this share of it the quotient of two is off by 2^-62 of itself, and rounds to within 0.51 ulp.
// The same serves for a component of n, of two products of two.
inline constexpr double kWellConditioned = 0x1p-32;

// Between these no product of three overflows, and no error term underflows: 2^-600 - 106.
inline constexpr double kSmallestFace = 0x1p-200;
inline constexpr double kLargestFace = 0x1p+200;

/// A triangle and a ray: three numbers each.
struct FaceInput {
  const double* corner[3];
  const double* origin;
  const double* direction;
};

struct FaceValues {
  double against_normal;  ///< a number with the sign of normal . direction
  double scale;           ///< as in RayPlace
  alignas(32) double normal[4];
};

/// Computes the values of place_on_face() and unit_normal(), but for the sign of a zero of the
/// normal. Returns false where it leaves that to these.
bool face_values(const FaceInput& in, FaceValues& out);

}  // namespace graze::narrowphase
