#pragma once

// Computes exactly with sums of doubles, after Shewchuk, "Adaptive precision floating-point
// arithmetic and fast robust geometric predicates", Discrete & Computational Geometry 18, 1997. An
// expansion is a sum of components that do not overlap, smallest first; the largest one has the
// sign of the sum. All is exact as long as nothing overflows and no product underflows, which the
// caller makes sure of.

#include <graze/narrowphase/predicates/predicates.h>
#include <array>
#include <cstddef>

namespace graze::narrowphase {

/// A rounded result and what it lacks: value + error is exact.
struct RoundedPair {
  double value;
  double error;
};

/// Returns Knuth's sum, exact for any two doubles whose sum does not overflow (Shewchuk, theorem
/// 7).
inline RoundedPair two_sum(double a, double b) {
  const double sum = a + b;
  const double b_virtual = sum - a;
  const double a_virtual = sum - b_virtual;
  return {sum, (a - a_virtual) + (b - b_virtual)};
}

/// Returns Dekker's product by Veltkamp's splitting (Shewchuk, theorem 18), without a fused
/// operation, so that it is the same, and as fast, on the baseline CPU.
inline RoundedPair two_product(double a, double b) {
  constexpr double kSplitter = 0x1p27 + 1;
  const double a_scaled = kSplitter * a;
  const double a_high = a_scaled - (a_scaled - a);
  const double a_low = a - a_high;
  const double b_scaled = kSplitter * b;
  const double b_high = b_scaled - (b_scaled - b);
  const double b_low = b - b_high;
  const double product = a * b;
  const double error =
      a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low);
  return {product, error};
}

/// A sum of at most `Capacity` components, zeros left out.
template <std::size_t Capacity>
class Expansion {
 public:
  Expansion() = default;

  static Expansion difference(double a, double b) requires(Capacity == 2) {
    Expansion result;
    const RoundedPair pair = two_sum(a, -b);
    result.append(pair.error);
    result.append(pair.value);
    return result;
  }

  std::size_t size() const { return size_; }
  double operator[](std::size_t index) const { return components_[index]; }

  void append(double component) {
    if (component != 0) components_[size_++] = component;
  }

  Sign sign() const {
    if (size_ == 0) return Sign::Zero;
    return components_[size_ - 1] > 0 ? Sign::Positive : Sign::Negative;
  }

  /// Adds one double in place (grow-expansion, theorem 10).
  void grow(double addend) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const RoundedPair pair = two_sum(addend, components_[i]);
      if (pair.error != 0) components_[kept++] = pair.error;
      addend = pair.value;
    }
    size_ = kept;
    append(addend);
  }

 private:
  std::array<double, Capacity> components_;
  std::size_t size_ = 0;
};

/// Returns e + f, or e - f for factor -1 (expansion-sum, theorem 12). It asks no more of its
/// operands than that their components do not overlap, which all operations here preserve.
template <std::size_t M, std::size_t N>
Expansion<M + N> add_scaled(const Expansion<M>& e, const Expansion<N>& f, double factor) {
  Expansion<M + N> sum;
  for (std::size_t i = 0; i < e.size(); ++i)
    sum.append(e[i]);
  for (std::size_t i = 0; i < f.size(); ++i)
    sum.grow(factor * f[i]);
  return sum;
}

template <std::size_t M, std::size_t N>
Expansion<M + N> operator+(const Expansion<M>& e, const Expansion<N>& f) {
  return add_scaled(e, f, 1.0);
}

template <std::size_t M, std::size_t N>
Expansion<M + N> operator-(const Expansion<M>& e, const Expansion<N>& f) {
  return add_scaled(e, f, -1.0);
}

/// Returns e f: every product of components, exactly, added up.
template <std::size_t M, std::size_t N>
Expansion<2 * M * N> operator*(const Expansion<M>& e, const Expansion<N>& f) {
  Expansion<2 * M * N> product;
  for (std::size_t i = 0; i < e.size(); ++i) {
    for (std::size_t j = 0; j < f.size(); ++j) {
      const RoundedPair pair = two_product(e[i], f[j]);
      product.grow(pair.error);
      product.grow(pair.value);
    }
  }
  return product;
}

}  // namespace graze::narrowphase
