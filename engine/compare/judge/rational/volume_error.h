#pragma once

#include <graze/engine/cases/case.h>

#include <optional>

namespace graze::compare {

/// Whether a placed triangle and a closed volume share a point, exactly (law 3 for oriented boxes,
/// whose frame the triangle is placed into with its rounding).
bool referee_meets(const Triangle& triangle, const Aabb& box);
bool referee_meets(const Triangle& triangle, const Obb& box);
bool referee_meets(const Triangle& triangle, const Sphere& sphere);

/// Whether two volumes do; nothing where the library promises no exact answer (law 11).
std::optional<bool> referee_overlaps(const CaseShape& shape_a, const CaseShape& shape_b);

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
