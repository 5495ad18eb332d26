#include <graze/narrowphase/motion/long_roots.h>

#include <algorithm>
#include <cmath>

namespace graze::narrowphase {
namespace {

using Coefficients = std::vector<GrowingInteger>;

constexpr int kBitsOfDouble = 53;
constexpr int kFinestBits = 1074;

// So many halvings are made before it is asked whether roots coincide, which takes as long as
// hundreds of them.
constexpr int kPatience = 64;

int count_changes(const Coefficients& coefficients) {
  int changes = 0;
  Sign last = Sign::Zero;
  for (const GrowingInteger& each : coefficients) {
    const Sign sign = each.sign();
    if (sign == Sign::Zero) continue;
    changes += last != Sign::Zero && sign != last;
    last = sign;
  }
  return changes;
}

struct Halves {
  Coefficients first;
  Coefficients last;
};

/// Returns both halves times 2^degree, by de Casteljau's sums, each of them twice as large.
Halves halves_of(const Coefficients& coefficients) {
  const std::size_t degree = coefficients.size() - 1;
  Coefficients sums = coefficients;
  Halves halves{Coefficients(degree + 1), Coefficients(degree + 1)};
  for (std::size_t step = 0; step <= degree; ++step) {
    const int bits = static_cast<int>(degree - step);
    halves.first[step] = sums[0].shifted(bits);
    halves.last[degree - step] = sums[degree - step].shifted(bits);
    for (std::size_t i = 0; i + step < degree; ++i)
      sums[i] = sums[i] + sums[i + 1];
  }
  return halves;
}

LongDyadic first_half(const LongDyadic& low) {
  return {low.numerator.shifted(1), low.bits + 1};
}
LongDyadic middle_of(const LongDyadic& low) {
  return {low.numerator.shifted(1) + GrowingInteger(1), low.bits + 1};
}

class Isolation {
 public:
  Isolation(const LongPolynomial& f, int most_bits) : f_(f), most_bits_(most_bits) {}

  /// Isolates the roots. False if a stretch of 2^-most_bits_ has more than one root or a double
  /// one.
  bool isolate(const LongDyadic& low, const Coefficients& coefficients) {
    const int changes = count_changes(coefficients);
    if (changes == 0) return true;
    if (changes == 1) {
      roots.emplace_back(f_, low, coefficients);
      return true;
    }
    if (low.bits == most_bits_) return false;
    const Halves halves = halves_of(coefficients);
    if (!isolate(first_half(low), halves.first)) return false;
    if (halves.last[0].is_zero()) roots.emplace_back(f_, middle_of(low));
    return isolate(middle_of(low), halves.last);
  }

  std::vector<LongRoot> roots;

 private:
  const LongPolynomial& f_;
  int most_bits_;
};

}  // namespace

void LongRoot::refine() {
  Halves halves = halves_of(bernstein_);
  const LongDyadic middle = middle_of(low_);
  if (halves.last[0].is_zero()) {
    low_ = middle;
    is_dyadic_ = true;
  } else if (count_changes(halves.first) == 1) {
    low_ = first_half(low_);
    bernstein_ = std::move(halves.first);
  } else {
    low_ = middle;
    bernstein_ = std::move(halves.last);
  }
}

double LongRoot::rounded_down() {
  while (!is_dyadic_ && low_.numerator.bit_length() < kBitsOfDouble && low_.bits < kFinestBits)
    refine();
  const int surplus =
      std::max(low_.numerator.bit_length() - kBitsOfDouble, low_.bits - kFinestBits);
  const int dropped = std::max(surplus, 0);
  return std::ldexp(low_.numerator.shifted_down(dropped).to_double(), dropped - low_.bits);
}

// The basis on a stretch takes as long as dozens of halvings: it is found after 0, 1, 2, 4, ... of
// them.
Sign LongRoot::sign_of(const LongPolynomial& g) {
  if (g.is_zero()) return Sign::Zero;
  if (g.degree() == 0) return g.leading().sign();
  bool has_common = true;
  for (int halvings = 0;; halvings = std::max(2 * halvings, 1)) {
    if (is_dyadic_) return sign_at(g, low_);
    const Coefficients coefficients = bernstein(g, low_);
    if (count_changes(coefficients) == 0) {
      // In the open stretch g has the sign of those coefficients that are not zero.
      for (const GrowingInteger& each : coefficients) {
        if (!each.is_zero()) return each.sign();
      }
    }
    if (has_common && halvings >= kPatience) {
      has_common = false;
      const LongPolynomial common = greatest_common_divisor(*f_, g);
      // At most one of the common roots, which are simple roots of f, is in the stretch.
      if (common.degree() > 0 && count_changes(bernstein(common, low_)) % 2 == 1) return Sign::Zero;
    }
    for (int i = 0; i < std::max(halvings, 1) && !is_dyadic_; ++i)
      refine();
  }
}

Sign LongRoot::sign_before(const LongPolynomial& g) {
  const Sign sign = sign_of(g);
  return sign != Sign::Zero || g.degree() < 1 ? sign : -sign_before(derivative(g));
}

std::vector<LongRoot> long_roots_of(const LongPolynomial& f, LongPolynomial& simple) {
  if (f.degree() < 1) return {};
  const LongDyadic start{};
  const auto in = [&](const LongPolynomial& g, int most_bits, std::vector<LongRoot>& roots) {
    const Coefficients coefficients = bernstein(g, start);
    Isolation isolation(g, most_bits);
    if (!isolation.isolate(start, coefficients)) return false;
    roots = std::move(isolation.roots);
    if (coefficients.back().is_zero()) roots.emplace_back(g, LongDyadic{GrowingInteger(1), 0});
    return true;
  };
  std::vector<LongRoot> roots;
  if (in(f, kPatience, roots)) return roots;
  simple = square_free(f);
  in(simple, -1, roots);
  return roots;
}

}  // namespace graze::narrowphase
