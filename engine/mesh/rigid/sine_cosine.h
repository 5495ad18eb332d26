#pragma once

namespace graze {

struct SineCosine {
  double sine;
  double cosine;
};

/// The sine and cosine of an angle, and how far the cosine is from 1, which loses nothing where the
/// angle is small.
struct TurnValues {
  SineCosine unit;
  double versine;
};

/// Returns the values of an angle of at most kMostTurned, each within kTurnBound of the true value,
/// and 0 and 1 for an angle of 0. For angles below pi / 4 sine and versine are off by at most 2^-50
/// of themselves. The values are the same everywhere, while C libraries differ in the last bit.
TurnValues turn_values(double angle);

/// Returns the angle of the unit vector (cosine, sine), both at least 0: within 2^-49 of its own.
double angle_of(const SineCosine& unit);

/// Sines, cosines and versines are off by at most this.
inline constexpr double kTurnBound = 0x1p-50;

}  // namespace graze
