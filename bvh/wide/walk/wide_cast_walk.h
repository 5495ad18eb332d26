#pragma once

#include <graze/bvh/traverse/traversal.h>
#include <graze/bvh/tree/box_separation.h>
#include <graze/bvh/wide/tree/wide_tree.h>
#include <graze/bvh/wide/walk/aligned_boxes.h>
#include <graze/bvh/wide/walk/wide_pair_walk.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace graze::bvh {

/// Two primitives, by their places, and no more than how far B goes until they meet.
struct CastPlaces {
  PlacePair places;
  float bound;  ///< common units
};

/// Finds the pairs of primitives of two trees that may meet while B goes straight along a
/// direction, those that may meet sooner first as far as bounds tell. Boxes and primitives are
/// compared along six axes: the direction, four across it, which tell whether two are in each
/// other's way at all, and the normal of the best contact so far, along which surfaces are thin.
/// Hands out some at a time, so that the limit can follow what they turn out to be.
class WideCastWalk {
 public:
  /// One step may find as many pairs.
  static constexpr std::size_t kMostAtOnce = ChildLink::kMaxLeafSize * ChildLink::kMaxLeafSize;

  /// How tree B lies in tree A, with its slack (law 5), and where B goes, in the frame of A: not
  /// zero, of a length from 1/2 to 2, and off by 8 u of that in each component, u = 2^-53.
  WideCastWalk(const WideTree& tree_a, const WideTree& tree_b, const RelativeFrame& b_in_a,
               const double (&direction)[3]);

  /// The next pairs that may meet before B has gone so far, common units; none when there are no
  /// more. `found` has room for kMostAtOnce.
  std::size_t next(std::span<CastPlaces> found, double limit);

  /// Looks along this normal from now on, in the frame of A and of length 1 but for rounding: any
  /// vector is one. Nothing changes if it is nearly the one that there is, or across the direction.
  void take_normal(const double (&normal)[3]);

  const WideWalkCounts& counts() const { return counts_; }

  // What the kernels see.

  struct Waiting {
    WideChildRef a;
    WideChildRef b;
    float bound;
  };

  /// A node or a leaf along the direction and two axes across it, and along the normal and the two
  /// axes between these.
  template <typename Aligned>
  struct Along {
    Aligned straight;
    Aligned turned;
  };

  /// What was found along the axes, of nodes or leaves: a walk meets the same ones again and again.
  /// Nothing is allocated: what has the same place gives way.
  template <typename Kept, std::size_t kRoom>
  class Store {
   public:
    Store() { key_.fill(nullptr); }

    static std::size_t place_of(const void* key, std::size_t size) {
      return (std::hash<const void*>()(key) / size) % kRoom;
    }
    bool is_of(std::size_t place, const void* key) const { return key_[place] == key; }
    bool is_along(std::size_t place, std::uint32_t normal) const {
      return normal_[place] == normal;
    }
    Kept& set(std::size_t place, const void* key, std::uint32_t normal) {
      key_[place] = key;
      normal_[place] = normal;
      return kept_[place];
    }
    const Kept& at(std::size_t place) const { return kept_[place]; }

   private:
    std::array<const void*, kRoom> key_;
    std::array<std::uint32_t, kRoom> normal_;
    std::array<Kept, kRoom> kept_;
  };

  struct State {
    State(const WideTree& tree_a, const WideTree& tree_b, const RelativeFrame& frame);

    const WideTree* tree[2];
    RelativeFrame b_in_a;
    double direction[3];  ///< of length 1
    double across[2][3];
    double normal[3] = {0, 0, 0};
    float scale_b;  ///< the unit of B's tree in that of A's
    AlignedTransform straight[2];
    AlignedTransform turned[2];
    std::uint32_t normals = 0;  ///< how many there were
    /// What bounds along the normal are multiplied by: 0 as long as there is none.
    float per_normal = 0;
    TraversalStack<Waiting, 192> open;
    Store<Along<AlignedNode>, 64> nodes[2];
    Store<Along<AlignedLeaf>, 64> leaves[2];
  };

 private:
  void turn();

  State state_;
  WideWalkCounts counts_;
};

}  // namespace graze::bvh
