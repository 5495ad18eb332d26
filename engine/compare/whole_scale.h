#pragma once

#include <gmpxx.h>

namespace graze::compare {

/// Turns finite doubles into whole numbers in the same proportions: all are multiples of one power
/// of two, the largest that divides each of them.
class WholeScale {
 public:
  /// Takes a value into account. Every value must be included before the first whole().
  void include(double value);

  /// Returns the value divided by the common power of two, exactly.
  void whole(double value, mpz_class& result) const;

 private:
  int exponent_ = 2000;  ///< the exponent so far; at first above that of every double
};

}  // namespace graze::compare
