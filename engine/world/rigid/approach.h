#pragma once

// What bounds two shapes in motion. Private to engine/world.

#include <graze/engine/mesh/rigid/time_grid.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/world/rigid/moving_shape.h>
#include <graze/narrowphase/convex/core/core.h>

namespace graze {

/// By how much a gap closes, metres, in a stretch of time d of the whole, 1: no more than rate d +
/// bend d^2 / 2. The rate may be negative.
struct Closing {
  double rate, bend;
};

/// What turning adds to how a convex set moves along a unit vector from a time on: its core, as it
/// is then relative to `origin`, of which no point is further than `radius` from the centre of the
/// motion. With w the angle along the axis, a point x moves at w x (x - centre), which along n is
/// (n x w) . (x - centre), most at a support point; and its path bends by angle^2 times its
/// distance from the centre.
Closing turning_closing(const RigidMotion& motion, double time, const narrowphase::Core& core,
                        const Eigen::Vector3d& origin, const Eigen::Vector3d& along, double radius);

/// How two shapes in motion near each other, all in metres, and the times at which they are asked.
struct Approach {
  Eigen::Vector3d shift;  ///< of B, less that of A
  double turning_travel;  ///< turning moves points towards each other by no more
  double travel;          ///< and both by no more
  double limit;           ///< what is not further apart is no longer called free
  double rounding;        ///< what poses and distances are off by, at most
  TimeGrid grid{0};       ///< in a step of it nothing moves by more than a quarter of the tolerance

  Approach(const MovingShape& a, const MovingShape& b, const RigidContactSettings& settings);

  Approach mirrored() const;  ///< with A and B swapped

  /// How two convex sets close the gap between two planes at right angles to `normal`, unit, from A
  /// to B, whatever they do along these planes: Mirtich's bound (Impulse-based Dynamic Simulation
  /// of Rigid Body Systems, 1996, section 2.3). `turning` is what turning_closing() says of both.
  Closing closing(const Eigen::Vector3d& normal, const Closing& turning) const;
  /// Of any two sets.
  Closing closing() const { return {travel, 0}; }

  /// So many steps of the grid, at least 1, in which what is `gap` apart now, by a proof that holds
  /// but for `rounding`, stays apart; `most` if it does longer.
  std::uint64_t steps(double gap, const Closing& closing, std::uint64_t most) const;
};

}  // namespace graze
