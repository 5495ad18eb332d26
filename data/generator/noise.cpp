#include "data/generator/noise.h"

#include <cmath>

#include "data/generator/hash.h"

namespace graze::generator {
namespace {

// 6 t^5 - 15 t^4 + 10 t^3: slope and curvature are zero at 0 and at 1.
double fade(double t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}

double mix(double a, double b, double t) {
  return a + t * (b - a);
}

// 21 of the bits, as a number in [-1, 1).
double slope(std::uint64_t bits) {
  return static_cast<double>(bits & 0x1fffff) * 0x1p-20 - 1;
}

struct Cell {
  std::int64_t x, y, z;
  Eigen::Vector3d within;
  std::int64_t seed;

  // The linear function of one corner's slope that is zero in this corner.
  double corner(int i, int j, int k) const {
    const std::uint64_t bits = hash({seed, x + i, y + j, z + k});
    return slope(bits) * (within.x() - i) + slope(bits >> 21) * (within.y() - j) +
           slope(bits >> 42) * (within.z() - k);
  }

  double edge(int j, int k) const {
    return mix(corner(0, j, k), corner(1, j, k), fade(within.x()));
  }
  double face(int k) const { return mix(edge(0, k), edge(1, k), fade(within.y())); }
};

}  // namespace

double gradient_noise(const Eigen::Vector3d& point, std::int64_t seed) {
  const Eigen::Vector3d low(std::floor(point.x()), std::floor(point.y()), std::floor(point.z()));
  const Cell cell{static_cast<std::int64_t>(low.x()), static_cast<std::int64_t>(low.y()),
                  static_cast<std::int64_t>(low.z()), point - low, seed};
  return mix(cell.face(0), cell.face(1), fade(cell.within.z()));
}

double fractal_noise(const Eigen::Vector3d& point, const Fractal& fractal) {
  double sum = 0;
  double height = 1;
  double frequency = 1;
  for (int layer = 0; layer < fractal.layers; ++layer) {
    sum += height * gradient_noise(point * frequency, fractal.seed + layer);
    height *= fractal.gain;
    frequency *= 2;
  }
  return sum;
}

}  // namespace graze::generator
