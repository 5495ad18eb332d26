#pragma once

#include <graze/bvh/traverse/traversal.h>
#include <graze/bvh/tree/box_separation.h>
#include <graze/bvh/wide/lanes/tree_transform.h>
#include <graze/bvh/wide/tree/wide_tree.h>
#include <graze/bvh/wide/walk/aligned_boxes.h>
#include <graze/bvh/wide/walk/wide_pair_walk.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace graze::bvh {

/// Two primitives, by their places, and a lower bound of the square of their distance.
struct BoundedPlaces {
  PlacePair places;
  float squared_bound;  ///< common units
};

/// How lengths in the trees' frames and distances in space differ, in common units: each is at most
/// the other times `growth` and `margin` more.
struct LengthMargins {
  double growth;
  double margin;
};

/// Finds the pairs of primitives of two trees that their boxes, corners and planes do not prove
/// further apart than a limit, nearer ones first as far as bounds and middles tell. Depth first:
/// the memory is that of the trees' heights, and of what is left for later. Hands out some at a
/// time, so that the limit can follow what they turn out to be.
class WideDistanceWalk {
 public:
  /// One step may find as many pairs.
  static constexpr std::size_t kMostAtOnce = WidePairWalk::kMostAtOnce;

  /// How tree B lies in tree A and how A lies in B, each with its slack (law 5), in the same common
  /// units.
  WideDistanceWalk(const WideTree& tree_a, const WideTree& tree_b, const RelativeFrame& b_in_a,
                   const RelativeFrame& a_in_b, const LengthMargins& margins);

  /// Leaves what is beyond this share of the limit for later, when nothing else is left: a good
  /// limit is found soon, and what is left is looked at once, with that limit. Before next().
  void look_first_within(double share);

  /// The next pairs that may be within the root of `squared_limit`, in common units, and as near as
  /// the nearest points of primitives that were seen; none when there are no more. `found` has room
  /// for kMostAtOnce.
  std::size_t next(std::span<BoundedPlaces> found, double squared_limit);

  /// Looks also for gaps along this direction, which the nearest points found so far suggest: from
  /// A to B in the frame of A, of length 1 but for rounding, or 0. The point, in common units in
  /// the same frame, is near these.
  void aim_along(const double (&direction)[3], const double (&point)[3]);

  /// Whether a pair that was found is beyond a limit that has come down since.
  bool is_beyond(const BoundedPlaces& pair, double squared_limit) const;

  const WideWalkCounts& counts() const { return counts_; }

  // What the kernels see.

  struct Waiting {
    WideChildRef a;
    WideChildRef b;
    float squared_bound;
    float key;  ///< the order in which to look at them: the least first
  };

  /// So many nodes are opened before any are aligned: it must be worth it. Measured.
  static constexpr int kOpenedBefore = 16;

  struct State {
    State(const WideTree& tree_a, const WideTree& tree_b, const RelativeFrame& b_in_a,
          const RelativeFrame& a_in_b, const LengthMargins& margins);

    /// Along the present direction.
    void align();

    const WideTree* tree[2];
    RelativeFrame b_in_a;
    TreeTransform into[2];  ///< by the side of the tested node: of query boxes of the other tree
    float units[2];         ///< of each tree, in common units
    float growth;           ///< LengthMargins, twice over
    float margin;
    float direction[2][3] = {};  ///< in each tree's frame, from it to the other
    /// Of the distance, by the corners and the nearest points in float that were seen.
    float squared_upper_bound = std::numeric_limits<float>::infinity();
    TraversalStack<Waiting, 192> open;
    float squared_share = 1;  ///< of the limit: what is beyond it is left for later
    std::vector<Waiting> later;
    std::vector<BoundedPlaces> later_places;

    int opened = 0;
    bool is_turned = false;  ///< whether the direction is, since nodes were aligned
    bool is_aligned = false;
    double aim[3] = {};  ///< direction[0] in double, through `point`
    double point[3] = {};
    double aligned_aim[3] = {};
    AlignedTransform aligned_transform[2];
    AlignedNodes aligned[2];
  };

 private:
  // The cosine of an angle beyond which nodes are aligned anew. Measured.
  static constexpr double kAligned = 0.998;
  // What is left for later rarely outgrows it. Measured.
  static constexpr std::size_t kRoomForLater = 512;

  State state_;
  WideWalkCounts counts_;
};

}  // namespace graze::bvh
