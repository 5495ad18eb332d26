#pragma once

namespace graze {

struct SineCosine {
  double sine;
  double cosine;
};

/// And how far the cosine is from 1, which loses nothing where an angle is small.
struct TurnValues {
  SineCosine unit;
  double versine;
};

/// Of an angle of at most kMostTurned, each within kTurnBound of the true value, and 0 and 1 for an
/// angle of 0. Of angles below pi / 4 sine and versine are off by at most 2^-50 of themselves. The
/// same everywhere: C libraries differ in the last bit.
TurnValues turn_values(double angle);

/// The angle of the unit vector (cosine, sine), both at least 0: within 2^-49 of its own.
double angle_of(const SineCosine& unit);

/// How far sines, cosines and versines are off at most.
inline constexpr double kTurnBound = 0x1p-50;

}  // namespace graze
