#pragma once

#include <graze/bvh/tree/box_separation.h>
#include <graze/bvh/wide/front/front_planes.h>
#include <graze/bvh/wide/tree/wide_tree.h>

// What a motion does next is mostly what it did before. If each point b of a guest went by U(b) in
// one step, in which B came as far as `way`, and B comes as far as w from then on, b has gone by (w
// / way) U(b) and no further from there than what the steps have drifted from that in all. So a gap
// g along n lasts as long as
//   w (r |turn| - n . U(c)) / way + drift < g,
// in a ball of radius r around c, whatever the motion does. With drift <= kDrift w, which a clock
// sees to that runs as fast as the larger of w and drift / kDrift, it lasts until that clock is at
//   g / (kDrift + (r |turn| - n . U(c)) / way),
// where the quotient is no less than 0 and the sum no more than 1, because no point comes further
// than w.

namespace graze::bvh {

/// How far a guest may drift from its course, for each unit that it goes.
inline constexpr float kDrift = 0.0625f;

/// How guests of both trees, in the frames of their hosts, are expected to go on.
class FrontCourse {
 public:
  FrontCourse() = default;

  /// As they came from one pair of frames, of B in A and of A in B, to another: B by `way`, its
  /// rotation changed by `turn`.
  FrontCourse(const RelativeFrame (&before)[2], const RelativeFrame (&now)[2],
              const WideTree& tree_a, const WideTree& tree_b, double way, double turn);

  /// How far, at most, a point of either guest has come between these frames from where it was to
  /// come while B came as far as `way`.
  double drift(const RelativeFrame (&before)[2], const RelativeFrame (&now)[2], double way) const;

  /// Of guests of that host.
  const FrontWay& step(int host_side) const { return step_[host_side]; }
  float per_way() const { return static_cast<float>(1 / way_); }

 private:
  struct Guest {
    double rotation[3][3] = {};  // changes
    double translation[3] = {};
    double middle[3] = {};  // of its box, common units
    double half[3] = {};

    double drift(const RelativeFrame& before, const RelativeFrame& now, double share) const;
  };

  Guest guest_[2];  // of hosts A and B
  FrontWay step_[2];
  double way_ = 1;
};

}  // namespace graze::bvh
