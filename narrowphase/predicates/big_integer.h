#pragma once

#include <graze/narrowphase/predicates/predicates.h>
#include <array>
#include <cstdint>

namespace graze::narrowphase {

/// Thrown by integers that outgrow their capacity. It never leaves the library: the caller that
/// may meet it begins anew with wider integers.
struct CapacityExceeded {};

/// A signed integer of fixed capacity, in limbs of 64 bits. Slow, plain and always right. A copy
/// costs the limbs in use, not the capacity.
template <int Capacity>
class LongInteger {
 public:
  LongInteger() {}  // not defaulted: `LongInteger()` would clear all limbs
  LongInteger(const LongInteger& other);
  LongInteger& operator=(const LongInteger& other);

  /// Copies the same number with room for more, or for less if it fits.
  template <int OtherCapacity>
  explicit LongInteger(const LongInteger<OtherCapacity>& other);

  /// Returns value / 2^unit, which must be an integer: unit is at most
  /// exponent_of_lowest_bit(value).
  static LongInteger from_double(double value, int unit);

  Sign sign() const;
  bool is_zero() const { return size_ == 0; }

  /// Returns the number times 2^bits.
  LongInteger shifted(int bits) const;
  LongInteger operator-() const;

  /// Holds the highest 128 bits of the magnitude, which is (high * 2^64 + low) * 2^exponent but for
  /// what lies below them; the highest bit of `high` is set, unless all is zero.
  struct Leading {
    std::uint64_t high;
    std::uint64_t low;
    int exponent;
  };
  Leading leading() const;

  friend LongInteger operator+(const LongInteger& a, const LongInteger& b) { return sum(a, b); }
  friend LongInteger operator-(const LongInteger& a, const LongInteger& b) { return sum(a, -b); }
  friend LongInteger operator*(const LongInteger& a, const LongInteger& b) { return product(a, b); }

 private:
  template <int OtherCapacity>
  friend class LongInteger;

  static LongInteger sum(const LongInteger& a, const LongInteger& b);
  static LongInteger product(const LongInteger& a, const LongInteger& b);
  static int compare_magnitude(const LongInteger& a, const LongInteger& b);
  static LongInteger add_magnitude(const LongInteger& a, const LongInteger& b);
  static LongInteger subtract_magnitude(const LongInteger& larger, const LongInteger& smaller);

  std::array<std::uint64_t, Capacity> limbs_;  ///< least significant first; `size_` of them are set
  int size_ = 0;                               ///< no leading zeros are counted; 0 for zero
  bool is_negative_ = false;
};

/// This integer is wide enough for polynomials of degree six in differences of any finite doubles,
/// counted in units of the smallest one.
///
/// A finite double is an integer below 2^2098 times 2^-1074, so a difference or a sum of two has at
/// most 2099 bits. A product of six of these has 12594 bits, and a sum of up to 64 such products
/// 12600: 197 limbs. A product asks for the limbs of its factors together, each rounded up, which
/// of two factors is at most one limb more than their bits need: 198.
using BigInteger = LongInteger<200>;

/// This integer is wide enough for what signs at roots of polynomials ask for (motion/root_sign.h).
using HugeInteger = LongInteger<768>;

/// This integer is wide enough for comparing the times of two faces that a ball meets
/// (translation/ball_meetings.cpp).
using VastInteger = LongInteger<1000>;

extern template class LongInteger<200>;
extern template class LongInteger<768>;
extern template class LongInteger<1000>;

/// Returns the exponent of the lowest set bit of a finite double that is not zero.
int exponent_of_lowest_bit(double value);

}  // namespace graze::narrowphase
