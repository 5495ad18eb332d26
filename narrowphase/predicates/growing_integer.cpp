#include <graze/narrowphase/predicates/big_integer.h>
#include <graze/narrowphase/predicates/growing_integer.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace graze::narrowphase {

namespace {

__extension__ using DoubleLimb = unsigned __int128;

}  // namespace

GrowingInteger::GrowingInteger(Limbs limbs, bool is_negative)
    : limbs_(std::move(limbs)), is_negative_(is_negative) {
  while (!limbs_.empty() && limbs_.back() == 0)
    limbs_.pop_back();
}

GrowingInteger::GrowingInteger(int value)
    : GrowingInteger({static_cast<std::uint64_t>(std::abs(value))}, value < 0) {}

GrowingInteger GrowingInteger::from_double(double value, int unit) {
  if (value == 0) return {};
  const int lowest = exponent_of_lowest_bit(value);
  const double odd = std::abs(std::ldexp(value, -lowest));
  return GrowingInteger({static_cast<std::uint64_t>(odd)}, value < 0).shifted(lowest - unit);
}

Sign GrowingInteger::sign() const {
  if (is_zero()) return Sign::Zero;
  return is_negative_ ? Sign::Negative : Sign::Positive;
}

int GrowingInteger::bit_length() const {
  if (is_zero()) return 0;
  return 64 * static_cast<int>(limbs_.size()) - std::countl_zero(limbs_.back());
}

GrowingInteger GrowingInteger::shifted(int bits) const {
  if (is_zero() || bits == 0) return *this;
  const std::size_t whole = static_cast<std::size_t>(bits / 64);
  const int rest = bits % 64;
  Limbs limbs(limbs_.size() + whole + 1, 0);
  for (std::size_t i = 0; i < limbs_.size(); ++i) {
    limbs[whole + i] |= limbs_[i] << rest;
    if (rest != 0) limbs[whole + i + 1] = limbs_[i] >> (64 - rest);
  }
  return {std::move(limbs), is_negative_};
}

GrowingInteger GrowingInteger::shifted_down(int bits) const {
  const std::size_t whole = static_cast<std::size_t>(bits / 64);
  const int rest = bits % 64;
  if (whole >= limbs_.size()) return {};
  Limbs limbs(limbs_.size() - whole, 0);
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    limbs[i] = limbs_[whole + i] >> rest;
    if (rest != 0 && whole + i + 1 < limbs_.size())
      limbs[i] |= limbs_[whole + i + 1] << (64 - rest);
  }
  return {std::move(limbs), is_negative_};
}

GrowingInteger GrowingInteger::operator-() const {
  return {limbs_, !is_negative_};
}

double GrowingInteger::to_double() const {
  if (is_zero()) return 0;
  const double size = static_cast<double>(limbs_[0]);
  return is_negative_ ? -size : size;
}

int GrowingInteger::compare(const Limbs& a, const Limbs& b) {
  if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
  for (std::size_t i = a.size(); i-- > 0;) {
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  }
  return 0;
}

GrowingInteger::Limbs GrowingInteger::sum(const Limbs& a, const Limbs& b) {
  const Limbs &longer = a.size() < b.size() ? b : a, &shorter = a.size() < b.size() ? a : b;
  Limbs limbs(longer.size() + 1, 0);
  DoubleLimb carry = 0;
  for (std::size_t i = 0; i < longer.size(); ++i) {
    carry += DoubleLimb{longer[i]} + (i < shorter.size() ? shorter[i] : 0);
    limbs[i] = static_cast<std::uint64_t>(carry);
    carry >>= 64;
  }
  limbs.back() = static_cast<std::uint64_t>(carry);
  return limbs;
}

GrowingInteger::Limbs GrowingInteger::difference(const Limbs& larger, const Limbs& smaller) {
  Limbs limbs(larger.size(), 0);
  std::uint64_t borrow = 0;
  for (std::size_t i = 0; i < larger.size(); ++i) {
    const DoubleLimb rest = DoubleLimb{larger[i]} - (i < smaller.size() ? smaller[i] : 0) - borrow;
    limbs[i] = static_cast<std::uint64_t>(rest);
    borrow = static_cast<std::uint64_t>(rest >> 64) != 0 ? 1 : 0;
  }
  return limbs;
}

GrowingInteger operator+(const GrowingInteger& a, const GrowingInteger& b) {
  using Integer = GrowingInteger;
  if (a.is_negative_ == b.is_negative_) return {Integer::sum(a.limbs_, b.limbs_), a.is_negative_};
  if (Integer::compare(a.limbs_, b.limbs_) >= 0)
    return {Integer::difference(a.limbs_, b.limbs_), a.is_negative_};
  return {Integer::difference(b.limbs_, a.limbs_), b.is_negative_};
}

GrowingInteger operator-(const GrowingInteger& a, const GrowingInteger& b) {
  return a + -b;
}

GrowingInteger operator*(const GrowingInteger& a, const GrowingInteger& b) {
  if (a.is_zero() || b.is_zero()) return {};
  GrowingInteger::Limbs limbs(a.limbs_.size() + b.limbs_.size(), 0);
  for (std::size_t i = 0; i < a.limbs_.size(); ++i) {
    std::uint64_t carry = 0;
    for (std::size_t k = 0; k < b.limbs_.size(); ++k) {
      const DoubleLimb all = DoubleLimb{a.limbs_[i]} * b.limbs_[k] + limbs[i + k] + carry;
      limbs[i + k] = static_cast<std::uint64_t>(all);
      carry = static_cast<std::uint64_t>(all >> 64);
    }
    limbs[i + b.limbs_.size()] = carry;
  }
  return {std::move(limbs), a.is_negative_ != b.is_negative_};
}

// The division goes from the lowest word up: with an odd divisor each word of the quotient is the
// lowest that is left of the dividend times the inverse of the divisor's lowest (Jebelean, "An
// algorithm for exact division", Journal of Symbolic Computation 15(2), 1993).
GrowingInteger exact_quotient(const GrowingInteger& a, const GrowingInteger& b) {
  if (a.is_zero()) return {};
  int zeros = 0;
  while (b.limbs_[static_cast<std::size_t>(zeros) / 64] == 0)
    zeros += 64;
  zeros += std::countr_zero(b.limbs_[static_cast<std::size_t>(zeros) / 64]);
  const GrowingInteger divisor = b.shifted_down(zeros);
  GrowingInteger::Limbs rest = a.shifted_down(zeros).limbs_;
  const GrowingInteger::Limbs& d = divisor.limbs_;
  std::uint64_t inverse = 1;
  for (int i = 0; i < 6; ++i)  // each time twice as many bits are right
    inverse *= 2 - d[0] * inverse;
  const std::size_t count = rest.size() - d.size() + 1;
  GrowingInteger::Limbs limbs(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    limbs[i] = rest[i] * inverse;
    std::uint64_t borrow = 0;
    for (std::size_t k = 0; k < d.size() && i + k < count; ++k) {
      const DoubleLimb part = DoubleLimb{limbs[i]} * d[k] + borrow;
      const std::uint64_t low = static_cast<std::uint64_t>(part);
      borrow = static_cast<std::uint64_t>(part >> 64) + (rest[i + k] < low ? 1 : 0);
      rest[i + k] -= low;
    }
    for (std::size_t k = i + d.size(); k < count && borrow != 0; ++k) {
      const bool is_short = rest[k] < borrow;
      rest[k] -= borrow;
      borrow = is_short ? 1 : 0;
    }
  }
  return {std::move(limbs), a.is_negative_ != b.is_negative_};
}

}  // namespace graze::narrowphase
