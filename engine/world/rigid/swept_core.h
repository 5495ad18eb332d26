#pragma once

// Finds triangles that a convex set which goes straight surely passes. Private to engine/world.

#include <graze/narrowphase/convex/core/core.h>

namespace graze {

/// A convex set that goes straight, with its extents along a few directions: two axes across the
/// displacement and the two between them, the normal of a contact, along which both surfaces are
/// thin, or the displacement while there is none, and a triangle's own normal. With them most
/// triangles whose boxes are met need no search for the gap.
class SweptCore {
 public:
  /// Takes a set that is no triangle, and moves by t `displacement`, metres. `room` must be larger
  /// than needed by more than 2^-45 of all lengths, which covers the rounding here. The core must
  /// outlive this.
  SweptCore(const narrowphase::Core& core, const narrowphase::Vec3& displacement, double room);

  /// Takes the normal of a contact, a unit vector.
  void take_normal(const narrowphase::Vec3& normal);

  /// True only if the set is further than the room from the triangle at all t in [0, until].
  bool is_surely_passed(const narrowphase::Core& triangle, double until) const;

 private:
  static constexpr int kAcross = 4;

  /// The extent along a unit vector, with the room.
  struct Extent {
    double low, high;
  };
  Extent extent_along(const narrowphase::Vec3& unit) const;
  bool is_passed_along(const narrowphase::Vec3& unit, const Extent& own,
                       const narrowphase::Core& triangle, double until) const;

  const narrowphase::Core& core_;
  narrowphase::Vec3 displacement_;
  double room_;
  narrowphase::Vec3 across_[kAcross];
  Extent own_across_[kAcross];
  narrowphase::Vec3 normal_;  ///< the direction of the displacement, to begin with
  Extent own_normal_;
};

}  // namespace graze
