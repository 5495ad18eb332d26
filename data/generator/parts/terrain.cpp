#include "data/generator/parts/terrain.h"

#include <vector>

#include "data/generator/hash.h"
#include "data/generator/noise.h"

namespace graze::generator {
namespace {

constexpr int kCells = 100;
constexpr double kSide = 10;
constexpr double kWavelength = 4;
constexpr double kHeight = 1.1;
constexpr std::int64_t kSeed = 20;
constexpr Fractal kHills{kSeed, 7, 0.45};

// Vertices lie off the lattice by up to a fifth of a cell each way. The two sides of a triangle at
// its right angle are then (1 + a, b) and (c, 1 + d) cells with |a|, |b|, |c|, |d| <= 0.4: its area
// stays above (0.6 * 0.6 - 0.4 * 0.4) / 2 = 0.1 cells, so that no triangle turns over.
constexpr double kIrregularity = 0.2;

// Along x if `axis` is 0, along y if it is 1. The border stays straight.
double coordinate(int i, int j, int axis) {
  const int step = axis == 0 ? i : j;
  const double drawn = unit_interval(hash({kSeed, axis, i, j}));
  const double offset = step == 0 || step == kCells ? 0 : kIrregularity * (2 * drawn - 1);
  return kSide * ((step + offset) / kCells - 0.5);
}

}  // namespace

Surface make_terrain() {
  Surface surface;
  const auto vertex = [&](int i, int j) {
    const double x = coordinate(i, j, 0);
    const double y = coordinate(i, j, 1);
    // A third up: no layer is cut in one of its lattice planes, where the noise is flattest.
    const Eigen::Vector3d sample(x / kWavelength, y / kWavelength, 1.0 / 3);
    return surface.vertex({x, y, kHeight * fractal_noise(sample, kHills)});
  };
  for (int j = 0; j < kCells; ++j) {
    for (int i = 0; i < kCells; ++i) {
      const std::uint32_t a = vertex(i, j);
      const std::uint32_t b = vertex(i + 1, j);
      const std::uint32_t c = vertex(i + 1, j + 1);
      const std::uint32_t d = vertex(i, j + 1);
      // Diagonals alternate like the colours of a chess board.
      if ((i + j) % 2 == 0) {
        surface.quadrangle(a, b, c, d);
      } else {
        surface.quadrangle(b, c, d, a);
      }
    }
  }
  return surface;
}

}  // namespace graze::generator
