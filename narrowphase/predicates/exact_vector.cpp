#include <graze/narrowphase/predicates/exact_vector.h>
#include <algorithm>

namespace graze::narrowphase {

CommonUnit::CommonUnit(std::initializer_list<double> values) {
  include(values.begin(), static_cast<int>(values.size()));
}

void CommonUnit::include(const double* values, int count) {
  for (int i = 0; i < count; ++i) {
    if (values[i] != 0) unit_ = std::min(unit_, exponent_of_lowest_bit(values[i]));
  }
}

BigVector BigVector::difference(const double* a, const double* b, const CommonUnit& unit) {
  return {unit(a[0], b[0]), unit(a[1], b[1]), unit(a[2], b[2])};
}

BigInteger dot(const BigVector& a, const BigVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

BigVector cross(const BigVector& a, const BigVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace graze::narrowphase
