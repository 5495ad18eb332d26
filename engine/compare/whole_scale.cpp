#include <graze/engine/compare/whole_scale.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace graze::compare {
namespace {

// value = mantissa * 2^exponent with an integer mantissa of at most 53 bits; not zero. frexp and
// ldexp only move the exponent, denormals included, so that nothing is rounded.
struct Parts {
  double mantissa;
  int exponent;
};

Parts split(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return {std::ldexp(fraction, 53), exponent - 53};
}

}  // namespace

void WholeScale::include(double value) {
  if (value == 0) return;
  const Parts parts = split(value);
  const auto bits = static_cast<std::uint64_t>(std::abs(parts.mantissa));
  exponent_ = std::min(exponent_, parts.exponent + std::countr_zero(bits));
}

void WholeScale::whole(double value, mpz_class& result) const {
  mpz_ptr z = result.get_mpz_t();
  if (value == 0) {
    mpz_set_ui(z, 0);
    return;
  }
  const Parts parts = split(value);
  mpz_set_d(z, parts.mantissa);
  const int shift = parts.exponent - exponent_;
  if (shift >= 0) {
    mpz_mul_2exp(z, z, static_cast<mp_bitcnt_t>(shift));
  } else {  // include() saw this many zero bits at the end
    mpz_tdiv_q_2exp(z, z, static_cast<mp_bitcnt_t>(-shift));
  }
}

}  // namespace graze::compare
