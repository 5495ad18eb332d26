#pragma once

// From integers back to doubles, with one rounding. `exponent` scales by a power of two.

#include <graze/narrowphase/predicates/big_integer.h>

namespace graze::narrowphase {

/// numerator / denominator * 2^exponent, off by at most 0.51 ulp; infinite if it overflows. The
/// denominator is positive.
double rounded_ratio(const BigInteger& numerator, const BigInteger& denominator, int exponent);

/// The square root of numerator / denominator, times 2^exponent, likewise; both are positive.
double rounded_root_of_ratio(const BigInteger& numerator, const BigInteger& denominator,
                             int exponent);

}  // namespace graze::narrowphase
