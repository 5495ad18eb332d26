#include <graze/engine/cases/text/hex_float.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace graze::cases {
namespace {

constexpr int kFractionBits = 52;
constexpr int kExponentBias = 1023;
constexpr int kMinExponent = -1022;

int digit_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// Holds the digits before the exponent as `mantissa * 2^exponent`.
struct Mantissa {
  std::uint64_t value = 0;
  int exponent = 0;
  int digits = 0;
};

/// Takes digits from the front of `text`. Returns nothing if they do not fit 64 bits, of which
/// zeros at either end need none.
std::optional<Mantissa> take_mantissa(std::string_view& text) {
  constexpr std::uint64_t kTopDigit = std::uint64_t{0xf} << 60;
  constexpr int kMaxDigits = 400;  // more than any double needs, and far from overflow of exponents
  Mantissa result;
  bool is_fraction = false;
  int zeros = 0;  // zeros that may turn out to be the last digits
  for (; !text.empty(); text.remove_prefix(1)) {
    if (text.front() == '.' && !is_fraction) {
      is_fraction = true;
      continue;
    }
    const int digit = digit_of(text.front());
    if (digit < 0) break;
    if (++result.digits > kMaxDigits) return std::nullopt;
    if (is_fraction) result.exponent -= 4;
    ++zeros;
    if (digit == 0) continue;
    for (; zeros > 0; --zeros) {
      if (result.value == 0) {
        zeros = 1;
      } else if ((result.value & kTopDigit) != 0) {
        return std::nullopt;
      }
      result.value <<= 4;
    }
    result.value |= static_cast<std::uint64_t>(digit);
  }
  result.exponent += 4 * zeros;
  return result;
}

}  // namespace

std::string to_hex_float(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  std::string text = (bits >> 63) != 0 ? "-" : "";
  std::uint64_t fraction = bits & ((std::uint64_t{1} << kFractionBits) - 1);
  int exponent = static_cast<int>((bits >> kFractionBits) & 0x7ff);
  const bool is_normal = exponent != 0;
  if (!is_normal && fraction == 0) return text + "0x0p+0";
  exponent = is_normal ? exponent - kExponentBias : kMinExponent;
  text += is_normal ? "0x1" : "0x0";
  if (fraction != 0) text += '.';
  for (; fraction != 0; fraction = (fraction << 4) & ((std::uint64_t{1} << kFractionBits) - 1)) {
    text += "0123456789abcdef"[fraction >> (kFractionBits - 4)];
  }
  text += exponent < 0 ? "p-" : "p+";
  return text + std::to_string(exponent < 0 ? -exponent : exponent);
}

std::optional<double> parse_hex_float(std::string_view text) {
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.remove_prefix(1);
  if (!text.starts_with("0x") && !text.starts_with("0X")) return std::nullopt;
  text.remove_prefix(2);
  const std::optional<Mantissa> mantissa = take_mantissa(text);
  if (!mantissa || mantissa->digits == 0) return std::nullopt;
  if (!text.starts_with('p') && !text.starts_with('P')) return std::nullopt;
  text.remove_prefix(1);
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  }
  int exponent = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), exponent);
  if (end.ec != std::errc() || end.ptr != text.data() + text.size()) return std::nullopt;
  if (exponent < -5000 || exponent > 5000) return std::nullopt;
  exponent += mantissa->exponent;

  // ldexp rounds below the normal range only, and tells an overflow by infinity.
  const auto whole = static_cast<double>(mantissa->value);
  const double value = std::ldexp(whole, exponent);
  const bool is_exact =
      std::isfinite(value) && std::ldexp(value, -exponent) == whole &&
      (mantissa->value == 0 ||
       std::countl_zero(mantissa->value) + std::countr_zero(mantissa->value) >= 64 - 53);
  if (!is_exact) return std::nullopt;
  return is_negative ? -value : value;
}

}  // namespace graze::cases
