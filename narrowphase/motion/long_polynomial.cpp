#include <graze/narrowphase/motion/long_polynomial.h>

#include <algorithm>
#include <utility>

namespace graze::narrowphase {
namespace {

using Coefficients = std::vector<GrowingInteger>;

Coefficients coefficients_of(const LongPolynomial& f) {
  Coefficients all;
  for (int i = 0; i <= f.degree(); ++i)
    all.push_back(f[i]);
  return all;
}

GrowingInteger power(const GrowingInteger& base, int exponent) {
  GrowingInteger result(1);
  for (int i = 0; i < exponent; ++i)
    result = result * base;
  return result;
}

struct Division {
  LongPolynomial quotient;
  LongPolynomial remainder;
};

/// Divides f times the (deg f - deg g + 1)-th power of g's leading coefficient by g.
Division pseudo_division(const LongPolynomial& f, const LongPolynomial& g) {
  Coefficients rest = coefficients_of(f);
  const int steps = f.degree() - g.degree();
  Coefficients quotient(static_cast<std::size_t>(std::max(steps + 1, 0)));
  for (int k = steps; k >= 0; --k) {
    const GrowingInteger highest = rest.back();
    for (GrowingInteger& each : quotient)
      each = each * g.leading();
    quotient[static_cast<std::size_t>(k)] = highest;
    rest.pop_back();
    for (GrowingInteger& each : rest)
      each = each * g.leading();
    for (int i = 0; i < g.degree(); ++i) {
      GrowingInteger& each = rest[static_cast<std::size_t>(i) + static_cast<std::size_t>(k)];
      each = each - highest * g[i];
    }
  }
  return {LongPolynomial(std::move(quotient)), LongPolynomial(std::move(rest))};
}

LongPolynomial over(const LongPolynomial& f, const GrowingInteger& divisor) {
  Coefficients all = coefficients_of(f);
  for (GrowingInteger& each : all)
    each = exact_quotient(each, divisor);
  return LongPolynomial(std::move(all));
}

int binomial(int n, int k) {
  int result = 1;
  for (int i = 1; i <= k; ++i)
    result = result * (n - k + i) / i;
  return result;
}

}  // namespace

LongPolynomial::LongPolynomial(Coefficients coefficients) : coefficients_(std::move(coefficients)) {
  while (!coefficients_.empty() && coefficients_.back().is_zero())
    coefficients_.pop_back();
}

LongPolynomial operator+(const LongPolynomial& f, const LongPolynomial& g) {
  if (f.degree() < g.degree()) return g + f;
  Coefficients all = coefficients_of(f);
  for (int i = 0; i <= g.degree(); ++i)
    all[static_cast<std::size_t>(i)] = all[static_cast<std::size_t>(i)] + g[i];
  return LongPolynomial(std::move(all));
}

LongPolynomial operator-(const LongPolynomial& f, const LongPolynomial& g) {
  Coefficients negated = coefficients_of(g);
  for (GrowingInteger& each : negated)
    each = -each;
  return f + LongPolynomial(std::move(negated));
}

LongPolynomial operator*(const LongPolynomial& f, const LongPolynomial& g) {
  if (f.is_zero() || g.is_zero()) return {};
  Coefficients all(static_cast<std::size_t>(f.degree() + g.degree() + 1));
  for (int i = 0; i <= f.degree(); ++i) {
    for (int k = 0; k <= g.degree(); ++k) {
      GrowingInteger& each = all[static_cast<std::size_t>(i) + static_cast<std::size_t>(k)];
      each = each + f[i] * g[k];
    }
  }
  return LongPolynomial(std::move(all));
}

LongPolynomial derivative(const LongPolynomial& f) {
  Coefficients all;
  for (int i = 1; i <= f.degree(); ++i)
    all.push_back(f[i] * GrowingInteger(i));
  return LongPolynomial(std::move(all));
}

LongPolynomial greatest_common_divisor(const LongPolynomial& f, const LongPolynomial& g) {
  const bool is_shorter = f.degree() < g.degree();
  LongPolynomial u = is_shorter ? g : f, v = is_shorter ? f : g;
  GrowingInteger lead(1), height(1);
  while (true) {
    const int step = u.degree() - v.degree();
    const LongPolynomial rest = pseudo_division(u, v).remainder;
    if (rest.is_zero()) return v;
    if (rest.degree() == 0) return LongPolynomial({GrowingInteger(1)});
    const GrowingInteger divisor = lead * power(height, step);
    u = std::move(v);
    v = over(rest, divisor);
    lead = u.leading();
    if (step == 1) {
      height = lead;
    } else if (step > 1) {
      height = exact_quotient(power(lead, step), power(height, step - 1));
    }
  }
}

LongPolynomial square_free(const LongPolynomial& f) {
  if (f.degree() < 2) return f;
  const LongPolynomial common = greatest_common_divisor(f, derivative(f));
  return common.degree() < 1 ? f : pseudo_division(f, common).quotient;
}

Sign sign_at(const LongPolynomial& f, const LongDyadic& t) {
  if (f.is_zero()) return Sign::Zero;
  GrowingInteger value = f.leading();
  for (int i = f.degree() - 1; i >= 0; --i)
    value = value * t.numerator + f[i].shifted(t.bits * (f.degree() - i));
  return value.sign();
}

std::vector<GrowingInteger> bernstein(const LongPolynomial& f, const LongDyadic& from) {
  const int degree = f.degree();
  // The coefficients are those of powers of x, for t = (numerator + x) / 2^bits.
  Coefficients powers{f.leading()};
  for (int i = degree - 1; i >= 0; --i) {
    powers.emplace_back();
    for (std::size_t k = powers.size() - 1; k > 0; --k)
      powers[k] = powers[k - 1] + powers[k] * from.numerator;
    powers[0] = powers[0] * from.numerator + f[i].shifted(from.bits * (degree - i));
  }
  // A power x^i is the sum of (j choose i) / (degree choose i) of the j-th; times all binomials.
  int all = 1;
  for (int i = 0; i <= degree / 2; ++i)
    all *= binomial(degree, i);
  Coefficients result(powers.size());
  for (int j = 0; j <= degree; ++j) {
    for (int i = 0; i <= j; ++i) {
      const int weight = all / binomial(degree, i) * binomial(j, i);
      GrowingInteger& each = result[static_cast<std::size_t>(j)];
      each = each + powers[static_cast<std::size_t>(i)] * GrowingInteger(weight);
    }
  }
  return result;
}

}  // namespace graze::narrowphase
