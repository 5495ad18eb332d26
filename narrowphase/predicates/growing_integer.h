#pragma once

#include <graze/narrowphase/predicates/predicates.h>

#include <cstdint>
#include <vector>

namespace graze::narrowphase {

/// A signed integer of any length, on the heap: for what is asked seldom, and may need thousands of
/// words.
class GrowingInteger {
 public:
  GrowingInteger() = default;
  explicit GrowingInteger(int value);

  /// Returns value / 2^unit, which must be an integer: unit is at most
  /// exponent_of_lowest_bit(value).
  static GrowingInteger from_double(double value, int unit);

  Sign sign() const;
  bool is_zero() const { return limbs_.empty(); }
  /// Returns the number of bits of the magnitude.
  int bit_length() const;
  /// Return the number times 2^bits, and over it, rounded towards zero.
  GrowingInteger shifted(int bits) const;
  GrowingInteger shifted_down(int bits) const;
  GrowingInteger operator-() const;
  /// Returns the double that equals the number, which has at most 53 bits.
  double to_double() const;

  friend GrowingInteger operator+(const GrowingInteger& a, const GrowingInteger& b);
  friend GrowingInteger operator-(const GrowingInteger& a, const GrowingInteger& b);
  friend GrowingInteger operator*(const GrowingInteger& a, const GrowingInteger& b);
  /// Returns a / b, which must be an integer; b is not zero.
  friend GrowingInteger exact_quotient(const GrowingInteger& a, const GrowingInteger& b);

 private:
  using Limbs = std::vector<std::uint64_t>;
  GrowingInteger(Limbs limbs, bool is_negative);
  static int compare(const Limbs& a, const Limbs& b);
  static Limbs sum(const Limbs& a, const Limbs& b);
  static Limbs difference(const Limbs& larger, const Limbs& smaller);

  Limbs limbs_;  ///< the limbs of the magnitude, least significant first; the last is not zero
  bool is_negative_ = false;
};

}  // namespace graze::narrowphase
