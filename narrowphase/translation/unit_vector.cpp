#include <graze/narrowphase/derived/double_pair.h>
#include <graze/narrowphase/translation/unit_vector.h>

#include <algorithm>
#include <cmath>

namespace graze::narrowphase {

bool is_zero(const BigVector& v) {
  return v.x.is_zero() && v.y.is_zero() && v.z.is_zero();
}

Eigen::Vector3d unit_of(const BigVector& v) {
  const BigInteger* component[3] = {&v.x, &v.y, &v.z};
  Eigen::Vector3d unit(0, 0, 0);
  if (is_zero(v)) return unit;
  int exponent = 0;
  bool has_any = false;
  for (const BigInteger* c : component) {
    if (c->is_zero()) continue;
    const int own = c->leading().exponent;
    exponent = has_any ? std::max(exponent, own) : own;
    has_any = true;
  }
  const BigInteger one = BigInteger::from_double(1, 0);
  double rounded[3];
  for (int k = 0; k < 3; ++k)
    rounded[k] = rounded_ratio(*component[k], one, -exponent - 128);
  const double length =
      std::sqrt((rounded[0] * rounded[0] + rounded[1] * rounded[1]) + rounded[2] * rounded[2]);
  for (int k = 0; k < 3; ++k)
    unit.data()[k] = rounded[k] / length;
  return unit;
}

Eigen::Vector3d unit_against(const BigVector& v, const BigVector& d) {
  Eigen::Vector3d unit = unit_of(v);
  if (dot(v, d).sign() != Sign::Positive) return unit;
  for (int k = 0; k < 3; ++k)
    unit.data()[k] = -unit.data()[k];
  return unit;
}

}  // namespace graze::narrowphase
