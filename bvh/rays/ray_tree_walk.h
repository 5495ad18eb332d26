#pragma once

// This is the walk of a ray through a RayTree. It is private.
//
// All is in the tree's frame, where boxes are within 2 of its centre. The walk sees the ray from
// where it enters the box of all, so that floats are as fine as the tree is small, wherever the ray
// begins.
//
// Boxes. A face at x is crossed at x inverse - o inverse -+ padding |inverse|. In units of a
// coordinate, with S = 1 + slack, |o| is below 2.2 S and |x| below 2.01: o as a float is off by 2.2
// S, its product by 2.2 S, the padded one by 2.3 S, the face's product by 2.01 and the sum by 4.3
// S, times 2^-24. A component below 2^-30 is taken for that, which moves the ray by 2^-29 * 9 S
// within reach of the boxes. Together below 2^-19 S (tests/proofs/ray_tree.gappa).
//
// Leaves: see ray_leaf-inl.h.

#include <graze/bvh/rays/ray_frame.h>
#include <graze/bvh/rays/ray_tree.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// The aims that a walk may have.
enum class RayAim {
  First,  ///< candidates that are not behind a sure hit
  Any,    ///< the walk ends at a sure hit
  All,    ///< all candidates that are not surely missed
};

/// A primitive that the ray does not surely miss.
struct RayCandidate {
  std::uint32_t primitive;
  float least;   ///< the least s at which the ray may be in it, seen from the walk's start
  bool is_sure;  ///< true if the ray goes through it, within and not along it, before the first
                 ///< limit
  std::array<std::uint32_t, 3> corners;  ///< their numbers, if the leaves are
                                         ///< RayLeaves::SharedPoints, else 0 or the same
};

/// Counts what a walk did.
struct RayWalkCounts {
  std::uint32_t boxes = 0;
  std::uint32_t missed_boxes = 0;
  std::uint32_t primitives = 0;
};

/// The numbers that will be read of each candidate, to be fetched as soon as it is known: the
/// primitive's three indices, and three numbers at each of these. Without `points` those are left
/// to the caller, who does better if he walks for many rays first.
struct PrimitivePoints {
  const std::array<std::uint32_t, 3>* indices;
  const double* points;
};

/// A ray of the world: the points origin + s direction, s >= 0. No component of the direction is 2
/// or more, and the largest is at least 1.
struct RayToWalk {
  const RayFrame& frame;
  const double* origin;
  const double* direction;
  double limit;  ///< the largest s per_metre that counts
  RayAim aim;
  PrimitivePoints primitives;
};

/// A child that waits: a node's place, a lane of it, and a value that is not above any s in its
/// box. It is one number, so that whole numbers are in the order of these values.
using Open = std::uint64_t;

/// The axes as a ray sees them: the one along which it goes most as z, and the others as x and y.
/// They stand in the order x, y, z.
struct RayAxes {
  std::uint32_t axis[3];
  std::uint32_t row[3];   ///< the row of RayNode::box, as a number of floats
  std::uint32_t mask[3];  ///< the bits of each coordinate
  float per_bit[3];       ///< a leaf's extent times this is the lowest of these bits
};

/// The numbers that the kernels read and write, as seen from the start of the walk.
struct RayWalkState {
  // For boxes: s at a face is face inverse + near or far.
  alignas(16) float inverse[4];
  alignas(16) float near[4];
  alignas(16) float far[4];
  std::size_t near_row[3];  ///< the row of RayNode::box, as a number of floats
  std::size_t far_row[3];
  // For leaves, along x, y and z as the ray sees them:
  const RayAxes* axes;
  double origin[3];
  double lean[2];  ///< how far x and y lean for each unit of z
  double along;    ///< how much s changes for each unit of z
  float minus_lean[2];
  float float_along;
  float leaf_slack;  ///< the slack of leaned coordinates and of s
  float limit;
  float sure_limit;  ///< s below this count, whatever is rounded
  RayAim aim;
  PrimitivePoints primitives;
  /// The candidates that the caller has room for, and gets.
  std::span<RayCandidate> found;
  RayWalkCounts counts;
  bool is_blind;
  std::uint32_t open_count;
  Open* open;
  double start;
};

// The kernels return how many candidates they found.

/// Begins a walk, which for most rays is all of it. Fills in all but `open` and `found`.
std::size_t begin_ray_walk(const RayTree& tree, const RayToWalk& ray, RayWalkState& state);

std::size_t walk_ray_tree(const RayTree& tree, RayWalkState& state);

/// A walk through a RayTree that may be interrupted.
class RayTreeWalk {
 public:
  RayTreeWalk() = default;
  RayTreeWalk(const RayTreeWalk&) = delete;
  RayTreeWalk& operator=(const RayTreeWalk&) = delete;

  /// Finds up to `found.size()` candidates, which must be at least kAtOnce, roughly from near to
  /// far. Returns how many.
  std::size_t begin(const RayTree& tree, const RayToWalk& ray, std::span<RayCandidate> found) {
    state_.open = tree.most_open > kRoom ? more_room(tree.most_open) : room_;
    state_.found = found;
    return begin_ray_walk(tree, ray, state_);
  }

  /// Finds more of them, in the same place, unless all have been found.
  std::size_t go_on(const RayTree& tree) { return is_done() ? 0 : walk_ray_tree(tree, state_); }

  /// Returns what the last of these two did.
  const RayWalkCounts& counts() const { return state_.counts; }

  static constexpr std::size_t kAtOnce = RayTree::kLeafSize;
  bool is_done() const { return state_.open_count == 0; }

  /// True if nothing is known of where the ray is: it begins so far away that the mesh is lost in
  /// the rounding of its coordinates. Nothing is found then.
  bool is_blind() const { return state_.is_blind; }

  /// Lets no s per_metre above this count from now on.
  void limit_to(double s);

  bool is_beyond(const RayCandidate& candidate) const { return candidate.least > state_.limit; }

 private:
  static constexpr std::size_t kRoom = 256;

  Open* more_room(std::size_t count);

  RayWalkState state_;
  Open room_[kRoom];
  std::vector<Open> more_room_;  ///< room for trees that are deeper than any that is sane
};

}  // namespace graze::bvh
