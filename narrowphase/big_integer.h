#pragma once

#include <graze/narrowphase/predicates.h>
#include <array>
#include <cstdint>

namespace graze::narrowphase {

/// A signed integer of fixed capacity: wide enough for the product of three differences of any
/// finite doubles, counted in units of the smallest one. Slow, plain and always right.
///
/// A finite double is an integer below 2^2098 times 2^-1074; a difference of two has 2099 bits, the
/// product of three of them 6297, and a sum of six such products 6300 bits: 99 limbs.
class BigInteger {
 public:
  BigInteger() = default;

  /// value / 2^unit, which must be an integer: unit is at most exponent_of_lowest_bit(value).
  static BigInteger from_double(double value, int unit);

  Sign sign() const;

  friend BigInteger operator+(const BigInteger& a, const BigInteger& b);
  friend BigInteger operator-(const BigInteger& a, const BigInteger& b);
  friend BigInteger operator*(const BigInteger& a, const BigInteger& b);

 private:
  static constexpr int kCapacity = 100;

  static int compare_magnitude(const BigInteger& a, const BigInteger& b);
  static BigInteger add_magnitude(const BigInteger& a, const BigInteger& b);
  static BigInteger subtract_magnitude(const BigInteger& larger, const BigInteger& smaller);

  std::array<std::uint64_t, kCapacity> limbs_;  // least significant first; size_ of them are set
  int size_ = 0;                                // no leading zeros; 0 for zero
  bool is_negative_ = false;
};

/// The exponent of the lowest set bit of a finite double that is not zero.
int exponent_of_lowest_bit(double value);

}  // namespace graze::narrowphase
