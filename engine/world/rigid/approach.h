#pragma once

// Bounds how two shapes in motion come to each other. Private to engine/world.

#include <graze/engine/mesh/rigid/time_grid.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/world/rigid/moving_shape.h>
#include <graze/narrowphase/convex/core/core.h>

namespace graze {

/// Bounds how much a gap closes, metres: in a stretch d of the whole time, 1, by no more than rate
/// d + bend d^2 / 2. The rate may be negative.
struct Closing {
  double rate, bend;
};

/// Returns what turning adds to the motion of a convex set along a unit vector from a time on. The
/// core is that of the set at that time, relative to `origin`, and no point of it is further than
/// `radius` from the centre of the motion. With w the angle along the axis, a point x moves at w x
/// (x - centre), which along n is (n x w) . (x - centre), most at a support point; and its path
/// bends by angle^2 times its distance from the centre.
Closing turning_closing(const RigidMotion& motion, double time, const narrowphase::Core& core,
                        const Eigen::Vector3d& origin, const Eigen::Vector3d& along, double radius);

/// Says how two shapes in motion come to each other, all in metres, and at which times they are
/// asked.
struct Approach {
  Eigen::Vector3d shift;  ///< the shift of B minus that of A
  double turning_travel;  ///< turning moves points towards each other by no more than this
  double travel;          ///< the whole motions move points towards each other by no more than this
  double limit;           ///< shapes that are not further apart than this are no longer called free
  double rounding;        ///< the most by which poses and distances are off
  TimeGrid grid{0};       ///< in a step of the grid nothing moves by more than a quarter of the
                          ///< tolerance

  Approach(const MovingShape& a, const MovingShape& b, const RigidContactSettings& settings);

  Approach mirrored() const;  ///< the approach with A and B swapped

  /// Returns how two convex sets close the gap between two planes at right angles to `normal`,
  /// unit, from A to B, whatever they do along these planes: Mirtich's bound (Impulse-based Dynamic
  /// Simulation of Rigid Body Systems, 1996, section 2.3). `turning` is the sum of
  /// turning_closing() of both.
  Closing closing(const Eigen::Vector3d& normal, const Closing& turning) const;
  /// Returns how any two sets close a gap.
  Closing closing() const { return {travel, 0}; }

  /// Returns the number of steps of the grid, at least 1 and at most `most`, in which two sets stay
  /// apart that are now proved, but for `rounding`, to be `gap` apart.
  std::uint64_t steps(double gap, const Closing& closing, std::uint64_t most) const;
};

}  // namespace graze
