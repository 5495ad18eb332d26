#pragma once

// A convex set that goes straight, beside triangles. Private to engine/world.

#include <graze/narrowphase/convex/core/core.h>

namespace graze {

/// Seen along a few directions: two axes across the displacement and the two between them, the
/// normal of a contact, around which both surfaces are thin, or the displacement while there is
/// none, and a triangle's own normal. That spares most triangles whose boxes are met a search for
/// the gap.
class SweptCore {
 public:
  /// The set is no triangle, and moves by t `displacement`, metres. `room` has more than 2^-45 of
  /// all lengths beyond what it stands for: what is computed here is off by less. The core must
  /// outlive this.
  SweptCore(const narrowphase::Core& core, const narrowphase::Vec3& displacement, double room);

  /// Of a contact, a unit vector.
  void take_normal(const narrowphase::Vec3& normal);

  /// True only if the set is further than the room from the triangle at all t in [0, until].
  bool is_surely_passed(const narrowphase::Core& triangle, double until) const;

 private:
  static constexpr int kAcross = 4;

  /// Along a unit vector, with the room.
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
  narrowphase::Vec3 normal_;  ///< the displacement's, to begin with
  Extent own_normal_;
};

}  // namespace graze
