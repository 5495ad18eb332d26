#pragma once

#include <tests/oracle/sampler.h>

namespace graze::oracle {

/// Given that the referee's answer for make(0) and make(1) differs, halves the interval until its
/// ends are neighbours, or nearly, and returns a parameter at the flip or a few steps beside it. If
/// the answers agree, returns any parameter.
template <typename Make, typename Intersects>
double near_flip(Sampler& sampler, Make make, Intersects intersects) {
  double low = 0;
  double high = 1;
  const bool at_low = intersects(make(low));
  if (intersects(make(high)) == at_low) return sampler.unit();
  for (int i = 0; i < 60; ++i) {
    const double middle = low + (high - low) / 2;
    if (middle == low || middle == high) break;
    (intersects(make(middle)) == at_low ? low : high) = middle;
  }
  return sampler.nudged(sampler.one_in(2) ? low : high, sampler.one_in(2) ? 0 : 3);
}

}  // namespace graze::oracle
