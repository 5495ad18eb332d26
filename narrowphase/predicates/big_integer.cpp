#include <graze/narrowphase/predicates/big_integer.h>
#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace graze::narrowphase {
namespace {

__extension__ using Wide = unsigned __int128;

struct Decomposed {
  std::uint64_t mantissa;
  int exponent;  ///< value = mantissa * 2^exponent
};

Decomposed decompose(double value) {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(value);
  const int biased = static_cast<int>((bits >> 52) & 0x7ff);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  if (biased == 0) return {fraction, -1074};
  return {fraction | (std::uint64_t{1} << 52), biased - 1075};
}

}  // namespace

int exponent_of_lowest_bit(double value) {
  const Decomposed parts = decompose(value);
  return parts.exponent + std::countr_zero(parts.mantissa);
}

template <int Capacity>
LongInteger<Capacity>::LongInteger(const LongInteger& other)
    : size_(other.size_), is_negative_(other.is_negative_) {
  std::copy_n(other.limbs_.begin(), size_, limbs_.begin());
}

template <int Capacity>
template <int OtherCapacity>
LongInteger<Capacity>::LongInteger(const LongInteger<OtherCapacity>& other)
    : size_(other.size_), is_negative_(other.is_negative_) {
  if (size_ > Capacity) throw CapacityExceeded();
  std::copy_n(other.limbs_.begin(), size_, limbs_.begin());
}

template <int Capacity>
LongInteger<Capacity>& LongInteger<Capacity>::operator=(const LongInteger& other) {
  if (this == &other) return *this;
  size_ = other.size_;
  is_negative_ = other.is_negative_;
  std::copy_n(other.limbs_.begin(), size_, limbs_.begin());
  return *this;
}

template <int Capacity>
LongInteger<Capacity> LongInteger<Capacity>::from_double(double value, int unit) {
  LongInteger result;
  if (value == 0) return result;
  const Decomposed parts = decompose(value);
  const int trailing = std::countr_zero(parts.mantissa);
  const std::uint64_t odd = parts.mantissa >> trailing;
  const int shift = parts.exponent + trailing - unit;
  assert(shift >= 0);
  const int limb = shift / 64;
  const int bit = shift % 64;
  std::fill_n(result.limbs_.begin(), limb, 0);
  result.limbs_[limb] = odd << bit;
  result.size_ = limb + 1;
  const std::uint64_t carried = bit == 0 ? 0 : odd >> (64 - bit);
  if (carried != 0) result.limbs_[result.size_++] = carried;
  result.is_negative_ = std::signbit(value);
  return result;
}

template <int Capacity>
Sign LongInteger<Capacity>::sign() const {
  if (size_ == 0) return Sign::Zero;
  return is_negative_ ? Sign::Negative : Sign::Positive;
}

template <int Capacity>
auto LongInteger<Capacity>::leading() const -> Leading {
  if (size_ == 0) return {0, 0, 0};
  const auto limb = [&](int i) { return i >= 0 ? limbs_[i] : 0; };
  const std::uint64_t limbs[3] = {limb(size_ - 1), limb(size_ - 2), limb(size_ - 3)};
  const int shift = std::countl_zero(limbs[0]);
  const auto joined = [&](int i) {
    return shift == 0 ? limbs[i] : limbs[i] << shift | limbs[i + 1] >> (64 - shift);
  };
  return {joined(0), joined(1), 64 * (size_ - 2) - shift};
}

template <int Capacity>
int LongInteger<Capacity>::compare_magnitude(const LongInteger& a, const LongInteger& b) {
  if (a.size_ != b.size_) return a.size_ < b.size_ ? -1 : 1;
  for (int i = a.size_ - 1; i >= 0; --i) {
    if (a.limbs_[i] != b.limbs_[i]) return a.limbs_[i] < b.limbs_[i] ? -1 : 1;
  }
  return 0;
}

template <int Capacity>
LongInteger<Capacity> LongInteger<Capacity>::add_magnitude(const LongInteger& a,
                                                           const LongInteger& b) {
  LongInteger sum;
  std::uint64_t carry = 0;
  const int size = std::max(a.size_, b.size_);
  for (int i = 0; i < size; ++i) {
    const Wide total =
        Wide{i < a.size_ ? a.limbs_[i] : 0} + (i < b.size_ ? b.limbs_[i] : 0) + carry;
    sum.limbs_[i] = static_cast<std::uint64_t>(total);
    carry = static_cast<std::uint64_t>(total >> 64);
  }
  sum.size_ = size;
  if (carry != 0) {
    if (sum.size_ == Capacity) throw CapacityExceeded();
    sum.limbs_[sum.size_++] = carry;
  }
  return sum;
}

template <int Capacity>
LongInteger<Capacity> LongInteger<Capacity>::subtract_magnitude(const LongInteger& larger,
                                                                const LongInteger& smaller) {
  LongInteger difference;
  std::uint64_t borrow = 0;
  for (int i = 0; i < larger.size_; ++i) {
    const std::uint64_t subtrahend = i < smaller.size_ ? smaller.limbs_[i] : 0;
    const Wide total = Wide{larger.limbs_[i]} - subtrahend - borrow;
    difference.limbs_[i] = static_cast<std::uint64_t>(total);
    borrow = static_cast<std::uint64_t>(total >> 64) != 0;
  }
  difference.size_ = larger.size_;
  while (difference.size_ > 0 && difference.limbs_[difference.size_ - 1] == 0)
    --difference.size_;
  return difference;
}

template <int Capacity>
LongInteger<Capacity> LongInteger<Capacity>::sum(const LongInteger& a, const LongInteger& b) {
  if (a.is_negative_ == b.is_negative_) {
    LongInteger sum = add_magnitude(a, b);
    sum.is_negative_ = a.is_negative_;
    return sum;
  }
  const int order = compare_magnitude(a, b);
  LongInteger sum = order >= 0 ? subtract_magnitude(a, b) : subtract_magnitude(b, a);
  sum.is_negative_ = order >= 0 ? a.is_negative_ : b.is_negative_;
  return sum;
}

template <int Capacity>
LongInteger<Capacity> LongInteger<Capacity>::operator-() const {
  LongInteger negated = *this;
  negated.is_negative_ = !is_negative_;
  return negated;
}

template <int Capacity>
LongInteger<Capacity> LongInteger<Capacity>::shifted(int bits) const {
  LongInteger result;
  if (size_ == 0) return result;
  const int limb = bits / 64;
  const int bit = bits % 64;
  if (size_ + limb + 1 > Capacity) throw CapacityExceeded();
  std::fill_n(result.limbs_.begin(), limb, 0);
  std::uint64_t carried = 0;
  for (int i = 0; i < size_; ++i) {
    result.limbs_[limb + i] = limbs_[i] << bit | carried;
    carried = bit == 0 ? 0 : limbs_[i] >> (64 - bit);
  }
  result.size_ = limb + size_;
  if (carried != 0) result.limbs_[result.size_++] = carried;
  result.is_negative_ = is_negative_;
  return result;
}

template <int Capacity>
LongInteger<Capacity> LongInteger<Capacity>::product(const LongInteger& a, const LongInteger& b) {
  LongInteger product;
  if (a.size_ == 0 || b.size_ == 0) return product;
  if (a.size_ + b.size_ > Capacity) throw CapacityExceeded();
  std::fill_n(product.limbs_.begin(), a.size_ + b.size_, 0);
  for (int i = 0; i < a.size_; ++i) {
    std::uint64_t carry = 0;
    for (int j = 0; j < b.size_; ++j) {
      const Wide total = Wide{a.limbs_[i]} * b.limbs_[j] + product.limbs_[i + j] + carry;
      product.limbs_[i + j] = static_cast<std::uint64_t>(total);
      carry = static_cast<std::uint64_t>(total >> 64);
    }
    product.limbs_[i + b.size_] = carry;
  }
  product.size_ = a.size_ + b.size_;
  while (product.limbs_[product.size_ - 1] == 0)
    --product.size_;
  product.is_negative_ = a.is_negative_ != b.is_negative_;
  return product;
}

template class LongInteger<200>;
template class LongInteger<768>;
template class LongInteger<1000>;
template LongInteger<768>::LongInteger(const LongInteger<200>&);
template LongInteger<200>::LongInteger(const LongInteger<768>&);
template LongInteger<1000>::LongInteger(const LongInteger<200>&);
template LongInteger<200>::LongInteger(const LongInteger<1000>&);

}  // namespace graze::narrowphase
