#pragma once

#include <graze/bvh/box_separation.h>
#include <graze/bvh/wide/wide_tree.h>

#include <cstddef>
#include <limits>

// How a gap along a direction n changes with the pose. In the host's frame, in common units, a
// point b of the guest lies at R b + t in one pose and at S b + v in another. If all b of a guest
// around c, |b - c| <= r, were g or more beyond some points of the host along n, |n| <= 1, they are
// now beyond these by at least
//   g + n . ((S - R) c + (v - t)) - r |S - R|.
// With a pose O, o of reference, u = (R - O) c + (t - o) and u' = (S - O) c + (v - o) that is g + n
// . (u' - u) - r |S - R|, and |S - R| is no more than what the turns of all steps between add up
// to.

namespace graze::bvh {

/// How a guest has come from where it was at first, common units.
struct FrontWay {
  float turned[3][3] = {};  // what its rotation has changed by
  float moved[3] = {};
  float turn = 0;   // the sum of all changes of its rotation
  float error = 0;  // of n . u for any point of the guest's tree, whatever rounds

  FrontWay() = default;

  /// From `first` to `now`, as frames of the guest, which is `guest`, in the host.
  FrontWay(const RelativeFrame& first, const RelativeFrame& now, const WideTree& guest,
           double all_turns);
};

/// The ball around what a box holds, in its own tree's frame, common units.
struct FrontBall {
  float centre[3];
  float radius;

  FrontBall() = default;
  FrontBall(const WideSlot& slot, float units);
};

/// What gaps of planes are multiplied by where they are stored, and where they are read: four
/// roundings each, and those of turns.
inline constexpr float kRoundPlanes = 1 - 0x1p-20f;

/// What is rounded to float, times it, is no more than before.
inline constexpr float kRoundDown = 1 - 0x1p-22f;

/// How far the middle of a guest has come since the pose of reference.
inline void set_step(float (&step)[3], const FrontBall& guest, const FrontWay& way) {
  for (int i = 0; i < 3; ++i) {
    step[i] = way.turned[i][0] * guest.centre[0] + way.turned[i][1] * guest.centre[1] +
              way.turned[i][2] * guest.centre[2] + way.moved[i];
  }
}

/// What keeps one pair out, as in FrontPlanes: nothing as it is made.
struct FrontPlane {
  float normal[3] = {};
  float gap = -std::numeric_limits<float>::infinity();

  FrontPlane() = default;

  /// The guest is `gap_now` beyond the host, after this way.
  FrontPlane(const double (&direction)[3], double gap_now, const FrontBall& guest,
             const FrontWay& way);

  /// How far it is at least after another way.
  float gap_after(const FrontBall& guest, const FrontWay& way) const;
};

/// What keeps pairs out: lane by lane a direction in the host's frame, no longer than 1, and how
/// far beyond the host a guest is along it. Gaps are those of the reference pose, but for what
/// turning may have cost; infinite in lanes that need no plane.
template <std::size_t lanes>
struct alignas(lanes * sizeof(float)) FrontPlanes {
  static constexpr std::size_t kLanes = lanes;
  float normal[3][kLanes];
  float gap[kLanes];
  FrontBall guest;
  int host_side;  // whose frame it is
};

}  // namespace graze::bvh
