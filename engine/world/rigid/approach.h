#pragma once

// What bounds two shapes in motion. Private to engine/world.

#include <graze/engine/mesh/rigid/time_grid.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/world/rigid/moving_shape.h>

namespace graze {

/// How two shapes in motion near each other, all in metres, and the times at which they are asked.
struct Approach {
  Eigen::Vector3d shift;  ///< of B, less that of A
  double turning_way;     ///< turning moves points towards each other by no more
  double way;             ///< and both by no more
  double limit;           ///< what is not further apart is no longer called free
  double rounding;        ///< what poses and distances are off by, at most
  TimeGrid grid{0};       ///< in a step of it nothing moves by more than a quarter of the tolerance

  Approach(const MovingShape& a, const MovingShape& b, const RigidContactSettings& settings);

  Approach mirrored() const;  ///< with A and B swapped

  /// How far two convex sets come nearer to each other in all, at most, whatever they do along the
  /// planes at right angles to `normal`, unit, from A to B, of which two keep them apart. Mirtich's
  /// bound (Impulse-based Dynamic Simulation of Rigid Body Systems, 1996, section 2.3).
  double closing_way(const Eigen::Vector3d& normal) const;

  /// So many steps of the grid, at least 1, in which what is `gap` apart now, by a proof that holds
  /// but for `rounding`, stays apart while it closes by `closing` in all; `most` if it does longer.
  std::uint64_t steps(double gap, double closing, std::uint64_t most) const;
};

}  // namespace graze
