#pragma once

#include <graze/narrowphase/predicates/predicates.h>
#include <array>
#include <cstdint>

namespace graze::narrowphase {

/// A signed integer of fixed capacity: wide enough for polynomials of degree six in differences of
/// any finite doubles, counted in units of the smallest one. Slow, plain and always right. A copy
/// costs the limbs in use, not the capacity.
///
/// A finite double is an integer below 2^2098 times 2^-1074, so a difference or a sum of two has at
/// most 2099 bits. A product of six of these has 12594 bits, and a sum of up to 64 such products
/// 12600: 197 limbs. A product asks for the limbs of its factors together, each rounded up, which
/// of two factors is at most one limb more than their bits need: 198.
class BigInteger {
 public:
  BigInteger() {}  // not defaulted: `BigInteger()` would clear all limbs
  BigInteger(const BigInteger& other);
  BigInteger& operator=(const BigInteger& other);

  /// value / 2^unit, which must be an integer: unit is at most exponent_of_lowest_bit(value).
  static BigInteger from_double(double value, int unit);

  Sign sign() const;

  /// The highest 128 bits of the magnitude, which is (high * 2^64 + low) * 2^exponent but for what
  /// lies below them; the highest bit of `high` is set, unless all is zero.
  struct Leading {
    std::uint64_t high;
    std::uint64_t low;
    int exponent;
  };
  Leading leading() const;

  friend BigInteger operator+(const BigInteger& a, const BigInteger& b);
  friend BigInteger operator-(const BigInteger& a, const BigInteger& b);
  friend BigInteger operator*(const BigInteger& a, const BigInteger& b);

 private:
  static constexpr int kCapacity = 200;

  static int compare_magnitude(const BigInteger& a, const BigInteger& b);
  static BigInteger add_magnitude(const BigInteger& a, const BigInteger& b);
  static BigInteger subtract_magnitude(const BigInteger& larger, const BigInteger& smaller);

  std::array<std::uint64_t, kCapacity>
      limbs_;     ///< least significant first; `size_` of them are set
  int size_ = 0;  ///< no leading zeros are counted; 0 for zero
  bool is_negative_ = false;
};

/// The exponent of the lowest set bit of a finite double that is not zero.
int exponent_of_lowest_bit(double value);

}  // namespace graze::narrowphase
