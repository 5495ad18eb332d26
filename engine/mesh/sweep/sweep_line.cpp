#include <graze/engine/mesh/sweep/sweep_line.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {

SweepLine::SweepLine(const Eigen::Vector3d& displacement, const contacts::SweepUnits& units) {
  const double* d = displacement.data();
  const double largest = std::max(std::abs(d[0]), std::max(std::abs(d[1]), std::abs(d[2])));
  if (largest == 0) return;
  const int own = std::ilogb(largest) + 1;
  for (int k = 0; k < 3; ++k)
    direction[k] = std::ldexp(d[k], -own);
  exponent = own - std::ilogb(units.metres);
}

double SweepLine::at(double time) const {
  if (time == 0) return 0;
  return std::nextafter(std::ldexp(time, exponent), std::numeric_limits<double>::infinity());
}

}  // namespace graze
