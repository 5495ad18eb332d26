#include <graze/narrowphase/derived/double_pair.h>
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace graze::narrowphase {
namespace {

__extension__ using Wide = unsigned __int128;

/// The positive number bits * 2^exponent, with bits at least 2^61.
struct Quotient {
  std::uint64_t bits;
  int exponent;
};

/// Returns a quotient that is off by less than 2^-60 of itself: with N >= 2^127 and D >= 2^63, N /
/// 4 and D truncated are off by 2^-125 and 2^-63 of themselves, their quotient, at least 2^61, by
/// another 1.
Quotient quotient(const BigInteger& numerator, const BigInteger& denominator) {
  const BigInteger::Leading n = numerator.leading();
  const BigInteger::Leading d = denominator.leading();
  const Wide dividend = (Wide{n.high} << 64 | n.low) >> 2;  // below 2^126: the quotient below 2^63
  return {static_cast<std::uint64_t>(dividend / d.high), n.exponent + 2 - (d.exponent + 64)};
}

}  // namespace

double rounded_ratio(const BigInteger& numerator, const BigInteger& denominator, int exponent) {
  if (numerator.sign() == Sign::Zero) return 0;
  const Quotient q = quotient(numerator, denominator);
  // Where the result is denormal, a second rounding, of half an ulp as well, would take the last
  // bits. It is avoided by rounding once to what fits, with a bit that remembers the rest.
  const int scale = q.exponent + exponent;
  std::uint64_t bits = q.bits;
  int dropped = 0;
  if (scale < -1074) {
    dropped = std::min(-1074 - scale, 63);
    const std::uint64_t rest = bits & ((std::uint64_t{1} << dropped) - 1);
    const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
    bits = (bits >> dropped) + (rest > half ? 1 : 0);
  }
  const double size = std::ldexp(static_cast<double>(bits), scale + dropped);
  return numerator.sign() == Sign::Negative ? -size : size;
}

double rounded_root_of_ratio(const BigInteger& numerator, const BigInteger& denominator,
                             int exponent) {
  Quotient q = quotient(numerator, denominator);
  if (q.exponent % 2 != 0) {
    q.bits >>= 1;
    ++q.exponent;
  }
  // The high and the low half of the bits are doubles, exactly.
  const double high = std::ldexp(static_cast<double>(q.bits >> 32), 32);
  const double low = static_cast<double>(q.bits & 0xffffffff);
  return std::ldexp(rounded_root(ordered_sum(high, low)), q.exponent / 2 + exponent);
}

}  // namespace graze::narrowphase
