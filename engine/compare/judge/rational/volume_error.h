#pragma once

#include <graze/engine/cases/case.h>

#include <optional>

namespace graze::compare {

/// True if a placed triangle and a closed volume share a point, exactly (law 3 for oriented boxes,
/// whose frame the triangle is placed into with its rounding).
bool referee_meets(const Triangle& triangle, const Aabb& box);
bool referee_meets(const Triangle& triangle, const Obb& box);
bool referee_meets(const Triangle& triangle, const Sphere& sphere);

/// Returns whether two volumes share a point; nothing where the library promises no exact answer
/// (law 11).
std::optional<bool> referee_overlaps(const CaseShape& shape_a, const CaseShape& shape_b);

/// Says how far two shapes are from the other answer, metres.
struct VolumeError {
  bool is_hit;
  /// The shortest translation that undoes a hit, else the gap. It is exact, and rounded once.
  double error;
};

/// Returns the error of a placed triangle and a volume; law 3 takes the triangle, or the ball's
/// centre, into the frame of an oriented box with its rounding.
VolumeError volume_error(const Triangle& triangle, const CaseShape& volume);

/// Returns the error of two volumes. Two oriented boxes, or one and an aligned one, are not quite
/// the same points by the two readings of a pose that is not quite a rotation; where these differ
/// it returns nothing.
std::optional<VolumeError> volume_error(const CaseShape& volume_a, const CaseShape& volume_b);

/// True for an oriented box with another box, of which only "apart" is promised (law 11).
bool is_conservative(const CaseShape& volume_a, const CaseShape& volume_b);

/// Returns the distance from the largest coordinate of a volume to the next double.
double largest_coordinate(const CaseShape& volume);

}  // namespace graze::compare
