#pragma once

// This is private to engine/mesh/rigid.

#include <graze/engine/mesh/rigid/moving_body.h>
#include <graze/engine/mesh/rigid/time_grid.h>
#include <graze/engine/mesh/rigid_contact.h>

#include <array>
#include <cstdint>

namespace graze {

/// A direction of length 1, but for rounding, in the common frame, from A to B.
struct ApartDirection {
  double n[3];
};

/// Both bodies as they are placed at one time.
struct PlacedBodies {
  std::uint64_t time;  ///< a time of the TimeGrid; ~0 for none
  Pose pose_a;
  Pose pose_b;
  double between[3];      ///< the offset from the origin of A to that of B
  double arm_a[3];        ///< the offset from the centre of A's motion, where it is at that time,
                          ///< to the origin of A
  double arm_b[3];        ///< the same offset for B
  double rotation[3][3];  ///< the rotation of B in A
};

/// Two bodies in motion, a grid of times that suits them, and their places at these times.
class MovingPair {
 public:
  MovingPair(const MovingBody& a, const MovingBody& b, const RigidContactSettings& settings);

  const MovingBody& a() const { return a_; }
  const MovingBody& b() const { return b_; }
  const TimeGrid& grid() const { return grid_; }

  /// Returns the limit, clearance and tolerance: distances up to it are too near.
  double limit() const { return limit_; }

  /// Returns a limit of gaps: a gap along a direction above it is, beyond all rounding, a distance
  /// above limit(). Directions are of length 1 but for a few roundings.
  double sure_limit() const { return limit_ * (1 + 0x1p-40) + rounding_; }

  /// Returns the rounding of both bodies, metres.
  double rounding() const { return rounding_; }

  /// Returns the bodies at a time of the grid; the reference outlives the next call, and no other.
  const PlacedBodies& at(std::uint64_t time) {
    PlacedBodies& placed = place_of(time);
    if (placed.time != time) place(time, placed);
    return placed;
  }

  /// Returns how far two points, one of each body, at most so far from its axis, move against each
  /// other in the span, metres.
  double displacement(const TimeSpan& span, double radius_a, double radius_b) const {
    return grid_.length(span) * (shift_ + (a_.turned * radius_a + b_.turned * radius_b));
  }

 private:
  PlacedBodies& place_of(std::uint64_t time) {
    // The times of a grid end in zeros; the product spreads them.
    std::size_t at = (time * 0x9e3779b97f4a7c15u) >> 58;
    if (placed_[at].time != time) {
      const std::size_t other = at ^ 1;
      if (placed_[other].time == time || at == recent_) at = other;
    }
    recent_ = at;
    return placed_[at];
  }
  void place(std::uint64_t time, PlacedBodies& placed) const;

  const MovingBody& a_;
  const MovingBody& b_;
  double shift_;  ///< how far the centres move against each other
  double rounding_;
  double limit_;
  TimeGrid grid_;
  static constexpr std::size_t kKept = 64;
  std::array<PlacedBodies, kKept> placed_;
  std::size_t recent_ = 0;  ///< the place that was asked for last
};

}  // namespace graze
