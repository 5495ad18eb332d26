#pragma once

#include <optional>

#include <graze/engine/cases/case.h>

namespace graze::compare {

/// How far two shapes are from the other answer, metres.
struct VolumeError {
  bool is_hit;
  /// Of a hit the shortest translation that undoes it, else the gap. Exact, and rounded once.
  double error;
};

/// Of a placed triangle and a volume; law 3 takes the triangle, or the ball's centre, into the
/// frame of an oriented box with its rounding.
VolumeError volume_error(const Triangle& triangle, const CaseShape& volume);

/// Of two volumes. Two oriented boxes, or one and an aligned one, are not quite the same points
/// by the two readings of a pose that is not quite a rotation; where these differ, nothing.
std::optional<VolumeError> volume_error(const CaseShape& volume_a, const CaseShape& volume_b);

/// Of an oriented box with another box only "apart" is promised (law 11).
bool is_conservative(const CaseShape& volume_a, const CaseShape& volume_b);

/// From the largest coordinate of a volume to the next double.
double largest_coordinate(const CaseShape& volume);

}  // namespace graze::compare
