#include "tests/narrowphase/motion/rational_polynomial.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace graze::oracle {
namespace {

void trim(RationalPolynomial& f) {
  while (!f.empty() && f.back() == 0)
    f.pop_back();
}

RationalPolynomial derivative(const RationalPolynomial& f) {
  RationalPolynomial result;
  for (std::size_t i = 1; i < f.size(); ++i)
    result.push_back(f[i] * static_cast<unsigned long>(i));
  return result;
}

struct Division {
  RationalPolynomial quotient;
  RationalPolynomial remainder;
};

Division divide(RationalPolynomial f, const RationalPolynomial& g) {
  Division result;
  if (f.size() >= g.size()) result.quotient.resize(f.size() - g.size() + 1);
  while (f.size() >= g.size()) {
    const mpq_class factor = f.back() / g.back();
    const std::size_t shift = f.size() - g.size();
    result.quotient[shift] = factor;
    for (std::size_t i = 0; i < g.size(); ++i)
      f[i + shift] -= factor * g[i];
    f.back() = 0;
    trim(f);
  }
  result.remainder = f;
  return result;
}

/// Sturm's sequence that begins with these two.
std::vector<RationalPolynomial> sequence(const RationalPolynomial& f, const RationalPolynomial& g) {
  std::vector<RationalPolynomial> all = {f, g};
  while (!all.back().empty()) {
    RationalPolynomial next = divide(all[all.size() - 2], all.back()).remainder;
    for (mpq_class& c : next)
      c = -c;
    all.push_back(in_integers(next));
  }
  all.pop_back();
  return all;
}

int changes_at(const std::vector<RationalPolynomial>& sequence, const mpq_class& t) {
  int changes = 0, last = 0;
  for (const RationalPolynomial& f : sequence) {
    const int sign = sign_of_value(f, t);
    if (sign == 0) continue;
    changes += last != 0 && sign != last;
    last = sign;
  }
  return changes;
}

class Isolation {
 public:
  explicit Isolation(const RationalPolynomial& f) : f_(f), sequence_(sequence(f, derivative(f))) {}

  /// The roots in (low, high), whose ends are none.
  void isolate(const mpq_class& low, const mpq_class& high, std::vector<RationalRoot>& roots) {
    const int count = changes_at(sequence_, low) - changes_at(sequence_, high);
    if (count == 0) return;
    if (count == 1) return roots.push_back({&f_, low, high});
    mpq_class middle = (low + high) / 2;
    mpq_class beside = (high - low) / 4;
    if (sign_of_value(f_, middle) != 0) {
      isolate(low, middle, roots);
      isolate(middle, high, roots);
      return;
    }
    while (sign_of_value(f_, middle - beside) == 0 || sign_of_value(f_, middle + beside) == 0 ||
           changes_at(sequence_, middle - beside) - changes_at(sequence_, middle + beside) != 1)
      beside /= 2;
    isolate(low, middle - beside, roots);
    roots.push_back({&f_, middle, middle});
    isolate(middle + beside, high, roots);
  }

 private:
  const RationalPolynomial& f_;
  std::vector<RationalPolynomial> sequence_;
};

}  // namespace

RationalPolynomial operator+(const RationalPolynomial& f, const RationalPolynomial& g) {
  RationalPolynomial sum(std::max(f.size(), g.size()));
  for (std::size_t i = 0; i < f.size(); ++i)
    sum[i] += f[i];
  for (std::size_t i = 0; i < g.size(); ++i)
    sum[i] += g[i];
  trim(sum);
  return sum;
}

RationalPolynomial operator-(const RationalPolynomial& f, const RationalPolynomial& g) {
  return f + g * RationalPolynomial{-1};
}

RationalPolynomial operator*(const RationalPolynomial& f, const RationalPolynomial& g) {
  if (f.empty() || g.empty()) return {};
  RationalPolynomial product(f.size() + g.size() - 1);
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (std::size_t k = 0; k < g.size(); ++k)
      product[i + k] += f[i] * g[k];
  }
  return product;
}

RationalPolynomial in_integers(RationalPolynomial f) {
  if (f.empty()) return f;
  mpz_class denominator = 1, factor = 0;
  for (const mpq_class& c : f)
    denominator = lcm(denominator, c.get_den());
  for (mpq_class& c : f) {
    c *= denominator;
    factor = gcd(factor, c.get_num());
  }
  for (mpq_class& c : f)
    c /= factor;
  return f;
}

int sign_of_value(const RationalPolynomial& f, const mpq_class& t) {
  mpz_class value = 0, scale = 1;
  for (std::size_t i = f.size(); i-- > 0;) {
    value = value * t.get_num() + f[i].get_num() * scale;
    scale *= t.get_den();
  }
  return sgn(value);
}

RationalPolynomial square_free(const RationalPolynomial& f) {
  const RationalPolynomial whole = in_integers(f);
  if (whole.size() < 2) return whole;
  return in_integers(divide(whole, sequence(whole, derivative(whole)).back()).quotient);
}

std::vector<RationalRoot> roots_of(const RationalPolynomial& f) {
  std::vector<RationalRoot> roots;
  if (f.size() < 2) return roots;
  Isolation isolation(f);
  mpq_class low = 0, high = 1;
  const std::vector<RationalPolynomial> all = sequence(f, derivative(f));
  const auto move_inwards = [&](mpq_class& end, const mpq_class& at, int direction) {
    mpq_class beside(direction, 2);
    while (sign_of_value(f, at + beside) == 0 || sign_of_value(f, at - beside) == 0 ||
           std::abs(changes_at(all, at - beside) - changes_at(all, at + beside)) != 1)
      beside /= 2;
    end = at + beside;
  };
  const bool has_zero = sign_of_value(f, 0) == 0, has_one = sign_of_value(f, 1) == 0;
  if (has_zero) {
    move_inwards(low, 0, 1);
    roots.push_back({&f, 0, 0});
  }
  if (has_one) move_inwards(high, 1, -1);
  if (low < high) isolation.isolate(low, high, roots);
  if (has_one) roots.push_back({&f, 1, 1});
  return roots;
}

void RationalRoot::refine() {
  if (low == high) return;
  const mpq_class middle = (low + high) / 2;
  const int sign = sign_of_value(*f, middle);
  if (sign == 0) {
    low = high = middle;
  } else {
    (sign == sign_of_value(*f, low) ? low : high) = middle;
  }
}

int compare(RationalRoot& a, RationalRoot& b) {
  const RationalPolynomial common = sequence(*a.f, *b.f).back();
  while (true) {
    if (a.low == a.high && b.low == b.high) return cmp(a.low, b.low);
    // A common end of two stretches lies between the roots, unless it is one.
    const bool are_stretches = a.low != a.high && b.low != b.high;
    if (a.high < b.low || (are_stretches && a.high == b.low)) return -1;
    if (b.high < a.low || (are_stretches && b.high == a.low)) return 1;
    if (a.low == a.high && sign_of_value(*b.f, a.low) == 0) {
      b.low = b.high = a.low;
    } else if (b.low == b.high && sign_of_value(*a.f, b.low) == 0) {
      a.low = a.high = b.low;
    } else if (are_stretches) {
      const mpq_class low = a.low < b.low ? b.low : a.low;
      const mpq_class high = a.high < b.high ? a.high : b.high;
      if (sign_of_value(common, low) * sign_of_value(common, high) < 0) {
        a.low = b.low = low;
        a.high = b.high = high;
        return 0;
      }
    }
    a.refine();
    b.refine();
  }
}

int sign_at(const RationalPolynomial& g, const RationalRoot& given) {
  RationalRoot root = given;
  if (root.low == root.high || g.size() < 2) return sign_of_value(g, root.low);
  // g is zero there if what f and g have in common is; that has simple roots, as f does.
  const RationalPolynomial common = sequence(g, in_integers(divide(*root.f, g).remainder)).back();
  if (sign_of_value(common, root.low) != sign_of_value(common, root.high)) return 0;
  const std::vector<RationalPolynomial> roots_of_g = sequence(g, derivative(g));
  while (true) {
    const int sign = sign_of_value(g, root.low);
    if (root.low == root.high) return sign;
    if (sign != 0 && sign == sign_of_value(g, root.high) &&
        changes_at(roots_of_g, root.low) == changes_at(roots_of_g, root.high))
      return sign;
    root.refine();
  }
}

double rounded_down(const RationalRoot& root) {
  if (root.low == root.high) {
    return root.low.get_d();  // towards zero
  }
  const int sign_low = sign_of_value(*root.f, root.low);
  // The largest double at which the root has not been passed; the sign changes at simple roots.
  std::uint64_t low = 0, high = std::bit_cast<std::uint64_t>(1.0);
  while (high - low > 1) {
    const std::uint64_t middle = low + (high - low) / 2;
    const mpq_class time(std::bit_cast<double>(middle));
    const bool is_passed =
        time >= root.high || (time > root.low && sign_of_value(*root.f, time) == -sign_low);
    (is_passed ? high : low) = middle;
  }
  return std::bit_cast<double>(low);
}

std::vector<RationalRoot> all_roots(const std::vector<RationalPolynomial>& polynomials) {
  std::vector<RationalRoot> all;
  for (const RationalPolynomial& f : polynomials) {
    for (RationalRoot root : roots_of(f)) {
      auto place = all.begin();
      int order = 1;
      while (place != all.end() && (order = compare(root, *place)) > 0)
        ++place;
      if (place == all.end() || order != 0) all.insert(place, root);
    }
  }
  return all;
}

}  // namespace graze::oracle
