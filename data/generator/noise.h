#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace graze::generator {

/// How layers of gradient noise are summed: layer i has the wavelength 2^-i and the height gain^i.
struct Fractal {
  std::int64_t seed;
  int layers;
  double gain;
};

/// Gradient noise: a continuous function with continuous first and second derivatives, zero at the
/// points of the whole-number lattice, with a random slope there, and mostly between -0.7 and 0.7.
/// Made of whole numbers, sums and products alone: the same on every machine.
/// Source: Perlin, Improving Noise, SIGGRAPH 2002, with slopes out of a cube instead of twelve.
double gradient_noise(const Eigen::Vector3d& point, std::int64_t seed);

/// The sum of the layers.
double fractal_noise(const Eigen::Vector3d& point, const Fractal& fractal);

}  // namespace graze::generator
