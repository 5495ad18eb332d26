#include "data/generator/parts/tolerances.h"

#include <array>
#include <cmath>

namespace graze::generator {
namespace {

constexpr std::array kR40 = {1.00, 1.06, 1.12, 1.18, 1.25, 1.32, 1.40, 1.50, 1.60, 1.70, 1.80,
                             1.90, 2.00, 2.12, 2.24, 2.36, 2.50, 2.65, 2.80, 3.00, 3.15, 3.35,
                             3.55, 3.75, 4.00, 4.25, 4.50, 4.75, 5.00, 5.30, 5.60, 6.00, 6.30,
                             6.70, 7.10, 7.50, 8.00, 8.50, 9.00, 9.50, 10.0};

constexpr double kMicrometre = 1e-3;  // in millimetres

}  // namespace

double round_to_r40(double value) {
  const double decade = std::pow(10, std::floor(std::log10(value)));
  double nearest = kR40.front();
  for (double candidate : kR40) {
    if (std::abs(candidate - value / decade) < std::abs(nearest - value / decade)) {
      nearest = candidate;
    }
  }
  return nearest * decade;
}

ThreadTolerances tolerances_6h_6g(double pitch, double range_mean) {
  // Fundamental deviations: g: es = -(15 + 11 P), H: EI = 0. Tolerances of grade 6:
  //   Td = 180 P^(2/3) - 3.15 / sqrt(P), Td2 = 90 P^0.4 d^0.1,
  //   TD2 = 1.32 Td2, TD1 = 230 P^0.7 for P >= 1. All in micrometres, P and d in millimetres.
  const double es = -round_to_r40(15 + 11 * pitch) * kMicrometre;
  const double major =
      round_to_r40(180 * std::pow(pitch, 2.0 / 3) - 3.15 / std::sqrt(pitch)) * kMicrometre;
  const double pitch_exact = 90 * std::pow(pitch, 0.4) * std::pow(range_mean, 0.1);
  const double external_pitch = round_to_r40(pitch_exact) * kMicrometre;
  const double internal_pitch = round_to_r40(1.32 * pitch_exact) * kMicrometre;
  const double internal_minor = round_to_r40(230 * std::pow(pitch, 0.7)) * kMicrometre;
  return {.external_major = {es, es - major},
          .external_pitch = {es, es - external_pitch},
          .internal_pitch = {internal_pitch, 0},
          .internal_minor = {internal_minor, 0}};
}

}  // namespace graze::generator
