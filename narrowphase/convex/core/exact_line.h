#pragma once

// Gives exact answers about a line and a hull where rounded arithmetic is not sure.

#include <graze/narrowphase/convex/core/hull.h>
#include <graze/narrowphase/predicates/predicates.h>

namespace graze::narrowphase {

/// The line origin + s direction, relative to the hull's middle, beside the exact corners. The
/// origin, the direction and the hull must outlive it.
class ExactLine {
 public:
  ExactLine(const Hull& hull, const Vec3& origin, const Vec3& direction)
      : hull_(hull), origin_(origin), direction_(direction) {}

  /// Returns the sign of ((p - o) x (q - o)) . d for corners p and q.
  Sign side_of_edge(std::uint32_t from, std::uint32_t to) const;

  /// Returns the sign of n . (v - o) for a corner v of the face and its outward normal n: Positive
  /// if o is behind.
  Sign side_of_origin(const Hull::Face& face) const;

  /// Returns the s at which the line is in the face's plane, which does not hold the line, rounded
  /// once from twice the precision of double, or from integers.
  double distance(const Hull::Face& face) const;

 private:
  double distance_by_integers(const Hull::Face& face) const;

  const Hull& hull_;
  const Vec3& origin_;
  const Vec3& direction_;
};

}  // namespace graze::narrowphase
