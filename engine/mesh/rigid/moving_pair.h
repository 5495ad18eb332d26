#pragma once

// Private to engine/mesh/rigid.

#include <graze/bvh/value/float_box.h>
#include <graze/engine/mesh/rigid/moving_body.h>
#include <graze/engine/mesh/rigid/time_grid.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/narrowphase/triangle.h>

#include <array>
#include <cstdint>

namespace graze {

/// A direction of length 1, but for rounding, in the common frame, from A to B.
struct ApartDirection {
  double n[3];
};

/// Both bodies at one time.
struct PlacedBodies {
  std::uint64_t time;  ///< as of TimeGrid; ~0 for none
  Pose pose_a;
  Pose pose_b;
  double offset[3];       ///< from the placed centre of A's tree frame to that of B's
  bool is_related;        ///< whether what follows is known
  double rotation[3][3];  ///< of B in A
  double size[3][3];      ///< |rotation|
  double offset_in_a[3];
};

/// Two bodies, the tolerance, and what keeps parts of them apart.
class MovingPair {
 public:
  MovingPair(const MovingBody& a, const MovingBody& b, const RigidContactSettings& settings);

  const MovingBody& a() const { return a_; }
  const MovingBody& b() const { return b_; }
  const TimeGrid& grid() const { return grid_; }

  /// Distances up to it are too near: clearance and tolerance.
  double limit() const { return limit_; }

  /// The bodies at a time of the grid; the reference outlives the next call, and no other.
  const PlacedBodies& at(std::uint64_t time);

  /// Finds the axis along which two boxes are furthest apart at this time. False if none has them
  /// further apart than the limit.
  bool find_direction(std::uint64_t time, const MetricBox& box_a, const MetricBox& box_b,
                      ApartDirection& direction);

  /// Whether a direction proves that no two points of the boxes come as near as the limit in the
  /// cell. `bulges` is turned^2 radius of both, added up.
  bool are_apart(const TimeCell& cell, const ApartDirection& direction, const MetricBox& box_a,
                 const MetricBox& box_b, double bulges);

  /// How far apart both must be along a direction at the ends of a cell, metres.
  double margin(const TimeCell& cell, double bulges) const {
    const double span = grid_.span(cell);
    return limit_ * kStretchOfLimit + span * span / 8 * bulges * kStretchOfLimit + rounding_;
  }

  MetricBox box_a(const bvh::FloatBox& box) const { return metric(box, a_.unit); }
  MetricBox box_b(const bvh::FloatBox& box) const { return metric(box, b_.unit); }

  /// How far two points, one of each body, at most so far from its axis, move against each other in
  /// the cell, metres.
  double displacement(const TimeCell& cell, double radius_a, double radius_b) const {
    return grid_.span(cell) * (shift_ + (a_.turned * radius_a + b_.turned * radius_b));
  }

 private:
  // Directions are of length 1 but for a few roundings.
  static constexpr double kStretchOfLimit = 1 + 0x1p-40;

  static MetricBox metric(const bvh::FloatBox& box, double unit);
  PlacedBodies& slot_of(std::uint64_t time);
  const PlacedBodies& related(std::uint64_t time);
  double gap(const PlacedBodies& placed, const ApartDirection& direction, const MetricBox& box_a,
             const MetricBox& box_b) const;

  const MovingBody& a_;
  const MovingBody& b_;
  double shift_;     ///< how far the centres move against each other
  double rounding_;  ///< of both bodies
  double limit_;
  TimeGrid grid_;
  static constexpr std::size_t kKept = 64;
  std::array<PlacedBodies, kKept> placed_;
  std::size_t recent_ = 0;  ///< the place that was asked for last
};

}  // namespace graze
