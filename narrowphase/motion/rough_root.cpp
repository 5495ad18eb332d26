#include <graze/narrowphase/motion/roots.h>

namespace graze::narrowphase {

double rough_root(const double (&coefficient)[4], int degree, double low, double high) {
  const auto value = [&](double t) {
    double sum = coefficient[degree];
    for (int i = degree - 1; i >= 0; --i)
      sum = sum * t + coefficient[i];
    return sum;
  };
  const bool is_low_positive = value(low) > 0;
  while (true) {
    const double middle = double_between(low, high);
    if (middle <= low || middle >= high) return low;
    ((value(middle) > 0) == is_low_positive ? low : high) = middle;
  }
}

}  // namespace graze::narrowphase
