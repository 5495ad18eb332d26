// An angle less a multiple of pi / 2 is r, of at most 0.7855 in size. With pi / 2 = h1 + h2 + h3,
// h1 and h2 of 33 bits, and a multiple k below 2^20, k h1 and k h2 are exact, and so is angle - k
// h1, for both are multiples of 2^-53 if k is not 0. What is subtracted then rounds twice, 2^-54
// each, and what h3 leaves of pi / 2 is below 2^-122: r is off by less than 2^-52.9. Taylor's
// series leave r^19 / 19! < 2^-63 and r^18 / 18! < 2^-58. What their evaluation rounds is proved in
// tests/proofs/sine_cosine.gappa, and all together is below kTurnBound.

#include <graze/engine/mesh/rigid/sine_cosine.h>

#include <array>
#include <cstdint>

namespace graze {
namespace {

constexpr double kPerQuarter = 0x1.45f306dc9c883p-1;  // 2 / pi
constexpr double kQuarter1 = 0x1.921fb544p+0;         // pi / 2
constexpr double kQuarter2 = 0x1.0b4611a6p-34;
constexpr double kQuarter3 = 0x1.3198a2e037073p-69;

/// The coefficients of the series: 1 / n! with their signs.
constexpr std::array<double, 8> kSine{
    -1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
    -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
constexpr std::array<double, 8> kCosine{
    -1.0 / 2,       1.0 / 24,        -1.0 / 720,         1.0 / 40320,
    -1.0 / 3628800, 1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000};

/// Returns x (c_0 + x (c_1 + ...)).
double series(const std::array<double, 8>& c, double x) {
  double sum = c[7];
  for (int i = 6; i >= 0; --i)
    sum = sum * x + c[i];
  return sum * x;
}

}  // namespace

TurnValues turn_values(double angle) {
  // Adding this rounds to an integer, for which no library is asked.
  constexpr double kIntegers = 0x1.8p52;
  const double k = (angle * kPerQuarter + kIntegers) - kIntegers;
  const double r = ((angle - k * kQuarter1) - k * kQuarter2) - k * kQuarter3;
  const double square = r * r;
  const double sine = r + r * series(kSine, square);
  const double below = series(kCosine, square);
  const double cosine = 1 + below;
  switch (static_cast<std::int64_t>(k) & 3) {
    case 0:
      return {{sine, cosine}, -below};
    case 1:
      return {{cosine, -sine}, 1 + sine};
    case 2:
      return {{-sine, -cosine}, 1 + cosine};
    default:
      return {{-cosine, sine}, 1 - sine};
  }
}

double angle_of(const SineCosine& unit) {
  // The first guess is off by less than 0.08; each step, by the sine of what is left, takes an
  // error e to e^3 / 6.
  double angle = unit.sine / (unit.sine + unit.cosine) * kQuarter1;
  for (int step = 0; step < 4; ++step) {
    const SineCosine guess = turn_values(angle).unit;
    angle += unit.sine * guess.cosine - unit.cosine * guess.sine;
  }
  return angle;
}

}  // namespace graze
