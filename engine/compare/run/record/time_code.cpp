#include <graze/engine/compare/run/record/time_code.h>

#include <algorithm>
#include <cmath>

namespace graze::compare {
namespace {

constexpr int kMantissaBits = 10;
constexpr int kLeastExponent = -20;
constexpr int kExponents = 63;

}  // namespace

std::uint16_t time_code(double value) {
  if (!(value > 0)) return 0;
  int exponent = 0;
  // value = share * 2^exponent, the share in [1/2, 1): in units of 2^-11 it has 1024 to 2047.
  const double share = std::frexp(std::min(value, 0x1p60), &exponent);
  const long units = std::lround(std::ldexp(share, kMantissaBits + 1));
  const long code =
      (exponent - 1 - kLeastExponent) * (1L << kMantissaBits) + units - (1L << kMantissaBits) + 1;
  return static_cast<std::uint16_t>(std::clamp(code, 1L, kExponents * (1L << kMantissaBits)));
}

double time_of_code(std::uint16_t code) {
  if (code == 0) return 0;
  const int place = code - 1;
  const int units = (1 << kMantissaBits) + place % (1 << kMantissaBits);
  return std::ldexp(units, place / (1 << kMantissaBits) + kLeastExponent - kMantissaBits);
}

void TimeMedian::add(double value) {
  if (!counts_) counts_ = std::make_unique<std::array<std::uint64_t, kCodes>>();
  ++(*counts_)[time_code(value)];
  ++count_;
}

double TimeMedian::median() const {
  if (!counts_) return 0;
  std::uint64_t before = 0;
  for (std::size_t code = 0; code < kCodes; ++code) {
    before += (*counts_)[code];
    if (before > count_ / 2) return time_of_code(static_cast<std::uint16_t>(code));
  }
  return 0;
}

}  // namespace graze::compare
