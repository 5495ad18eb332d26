#include "tests/benchmark/error/distances/rounded_distance.h"

#include <graze/engine/compare/referee.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/narrowphase/derived/rational_triangles.h"

namespace graze::benchmark {
namespace {

/// The square root of a positive number, to the nearest double: of the integer root of the number
/// scaled by 4^shift, 55 bits are kept, of which the last is set if anything was lost.
double rounded_root(const mpq_class& square) {
  const auto bits = [](const mpz_class& x) {
    return static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2));
  };
  const long shift = (130 - (bits(square.get_num()) - bits(square.get_den()))) / 2;
  mpz_class numerator = square.get_num(), denominator = square.get_den();
  (shift > 0 ? numerator : denominator) <<= static_cast<unsigned long>(2 * std::abs(shift));
  mpz_class root = sqrt(mpz_class(numerator / denominator));
  const bool is_exact = root * root * denominator == numerator;
  const auto extra = static_cast<unsigned long>(bits(root) - 55);
  mpz_class kept = root >> extra;
  if (!is_exact || (kept << extra) != root) kept |= 1;
  const auto rounded = static_cast<double>(kept.get_ui());  // 55 bits to 53, to nearest
  return std::ldexp(rounded, static_cast<int>(static_cast<long>(extra) - shift));
}

}  // namespace

double rounded_distance(const Triangle& a, const Triangle& b) {
  if (compare::referee_intersects(a, b)) return 0;
  const double root = rounded_root(oracle::rational_distance(a, b).square);
  return std::max(root, std::numeric_limits<double>::denorm_min());
}

double ulp_of(double number) {
  return std::ldexp(1, std::max(std::ilogb(number), -1022) - 52);
}

double largest_coordinate(const Triangle& t) {
  return std::max(
      {t.a.cwiseAbs().maxCoeff(), t.b.cwiseAbs().maxCoeff(), t.c.cwiseAbs().maxCoeff()});
}

}  // namespace graze::benchmark
