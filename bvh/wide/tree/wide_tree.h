#pragma once

#include <graze/bvh/tree/tree.h>
#include <graze/bvh/value/float_box.h>
#include <graze/bvh/value/local_frame.h>
#include <graze/bvh/wide/tree/corner_source.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace graze::bvh {

/// Up to eight boxes along axes that they share, fitted to what lies in them: the children of a
/// node of a WideTree. Lane j of each array speaks of child j.
///
/// A point p, in the tree's LocalFrame, of what child j holds, has |axis k . (p - origin)
/// - centre[k][j]| <= half[k][j] for each k, and is the sum of the origin and of s_k axis k with
/// |s_k - centre[k][j]| <= half[k][j] (law 5: wide_bounds.h).
///
/// It also lies in a slab across the third axis, tilted to fit: with n = a axis 0 + b axis 1 + axis
/// 2, a and b the slopes, and h = |a| half[0][j] + |b| half[1][j] + half[2][j], which is the
/// projected radius of the box along n, |n . (p - origin) - n . centre - slab_middle h| <=
/// slab_half h; likewise with the s_k in place of axis k . (p - origin). A slab costs four bytes,
/// and where surfaces bend it is several times thinner than a box along axes that eight children
/// share.
struct alignas(32) WideNode {
  static constexpr std::uint32_t kWidth = 8;

  float centre[3][kWidth];
  float half[3][kWidth];
  float axes[3][3];     ///< [component][axis]: unit vectors at right angles, but for rounding
  std::uint16_t count;  ///< the number of children, at least 1
  std::uint16_t
      has_slabs;  ///< whether slabs are so much thinner than boxes that it pays to ask them
  double origin[3];
  std::uint32_t child[kWidth];      ///< the children's links as ChildLink packs them
  std::int8_t slope[2][kWidth];     ///< q stands for q |q| 2^-14, which is finer where it is small
  std::int8_t slab_middle[kWidth];  ///< in units of 2^-7 h
  std::uint8_t slab_half[kWidth];   ///< in units of 2^-8 h, less one

  /// Returns the slope that a byte stands for: it is between -1 and 1, and exact.
  static float slope_of(std::int8_t q) {
    return static_cast<float>(q) * static_cast<float>(q < 0 ? -q : q) * kSlopeUnit;
  }

  static constexpr float kSlopeUnit = 0x1p-14f;
  static constexpr float kSlabMiddleUnit = 0x1p-7f;
  static constexpr float kSlabHalfUnit = 0x1p-8f;

  /// Returns the bits of the lanes that hold a child.
  std::uint32_t lanes() const { return (1u << count) - 1u; }
};
static_assert(sizeof(WideNode) == 320, "five cache lines");

/// Says what a lane of a node leads to: a node so many behind this one, another treelet, or a leaf,
/// whose primitives are counted from the treelet's first on.
struct ChildLink {
  static constexpr std::uint32_t kMaxLeafSize = 4;

  enum class Kind : std::uint32_t { Node, Treelet, Leaf };

  static std::uint32_t to_node(std::uint32_t behind) { return behind; }
  static std::uint32_t to_treelet(std::uint32_t index) { return kTreeletBit | index; }
  static std::uint32_t to_leaf(std::uint32_t first, std::uint32_t count) {
    return kLeafBit | (first << kCountBits) | (count - 1);
  }

  static constexpr bool is_leaf(std::uint32_t link) { return (link & kLeafBit) != 0; }
  static bool is_node(std::uint32_t link) { return link < kTreeletBit; }
  static bool is_treelet(std::uint32_t link) { return (link >> 30) == 1; }
  static std::uint32_t index(std::uint32_t link) { return link & ~kTreeletBit; }
  static std::uint32_t first(std::uint32_t link) { return (link & ~kLeafBit) >> kCountBits; }
  static std::uint32_t count(std::uint32_t link) { return (link & (kMaxLeafSize - 1)) + 1; }

 private:
  static constexpr std::uint32_t kLeafBit = 1u << 31;
  static constexpr std::uint32_t kTreeletBit = 1u << 30;
  static constexpr std::uint32_t kCountBits = 2;
};

/// A stretch of a wide tree's order, whose primitives are those of a treelet, and the box around
/// them.
struct TreeletPart {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  int depth = 0;  ///< the number of binary nodes above
  FloatBox box;
};

/// The nodes of a part of a wide tree, the number from which their leaves count primitives, and
/// these primitives' corners: in the tree's frame less an origin of the treelet's own, so that
/// floats tell points apart that are close for the treelet, however large the tree.
struct Treelet {
  std::vector<WideNode> nodes;
  std::vector<float> corners;  ///< a leaf has 9 rows, one behind the other, from 9 * its first on
  double origin[3] = {0, 0, 0};
  float largest_coordinate = 0;  ///< the largest size of a coordinate of a corner
  std::uint32_t first = 0;

  float built_cost = 0;   ///< cost_of() of the nodes when they were built
  float fitted_cost = 0;  ///< cost_of() of the nodes when their axes were last chosen
};

/// Counts how treelets came to be.
struct TreeletCounts {
  std::uint64_t built = 0;     ///< treelets that were made from primitives alone
  std::uint64_t refitted = 0;  ///< treelets that were made from the nodes of an earlier tree
};

/// The binary nodes above the treelets. A leaf among them is a treelet: its `first` counts parts,
/// its `count` primitives.
struct WideTop {
  std::vector<Node> nodes;
  std::vector<float> costs;  ///< the subtree_costs() when each node was built
  std::vector<TreeletPart> parts;
  /// The treelet that an earlier tree made of the same primitives in the same order, for each part
  /// that has one.
  std::vector<std::shared_ptr<const Treelet>> inherited;
};

/// The parts of a wide tree that the next one over the same primitives, elsewhere, begins with.
struct WideStock {
  WideTop top;
  std::vector<std::uint32_t> primitives;
};

/// A child of a node, by where the node stands: a walk has to remember no more of it.
struct WideChildRef {
  const WideNode* node;
  std::uint32_t lane;
  std::uint32_t treelet;
  bool operator==(const WideChildRef&) const = default;
};

/// The one topology collapsed to wide nodes. Its top is built at once, the treelets below it, of
/// two thousand primitives at most, when a walk first enters them: a tree that is asked little is
/// built little. It may be walked from many threads; its nodes are the same whenever and by
/// whomever they are built.
class WideTree {
 public:
  using Treelet = bvh::Treelet;

  /// Builds the top, in parallel. The source must outlive the tree; `bounds` holds all of it.
  WideTree(const Aabb& bounds, const CornerSource& source);

  /// Builds a tree over the primitives of the tree that left the stock, which may have moved
  /// anywhere: it refits the top, in parallel, and later treelets as they are entered. What has
  /// degraded is built anew.
  WideTree(const Aabb& bounds, const CornerSource& source, const WideStock& stock);

  /// Returns what the next tree over these primitives can begin with: it copies a few bytes a
  /// primitive, and shares treelets. It may be called beside walks.
  WideStock stock() const;

  const LocalFrame& frame() const { return frame_; }

  /// Returns the box of everything.
  const FloatBox& box() const { return box_; }

  /// Returns where walks begin: the box of everything.
  WideChildRef root() const { return {treelet(0).nodes.data(), 0, 0}; }

  /// Returns a treelet that has been built: the first is the top.
  const Treelet& treelet(std::uint32_t index) const {
    return *treelets_[index].built.load(std::memory_order_acquire);
  }

  /// Returns a treelet, which is built if this is the first time that it is asked for, and then
  /// counted.
  const Treelet& entered(std::uint32_t index, TreeletCounts& counts) const;

  /// Builds all that is not built yet, in parallel. Returns how many treelets that was.
  TreeletCounts build_all() const;

  /// Returns the primitive at this place in the order of the leaves. Its treelet must have been
  /// built.
  std::uint32_t primitive(std::uint32_t place) const { return primitives_[place]; }

  std::size_t treelet_count() const { return treelet_count_; }
  bool is_built(std::uint32_t index) const {
    return treelets_[index].built.load(std::memory_order_acquire) != nullptr;
  }

  /// Returns how many bytes the parts have that have been built so far.
  std::size_t bytes() const;

 private:
  /// A treelet that is built when it is first entered. `built` is set last, and once. What is
  /// inherited serves to build the treelet, and is then given up.
  struct LazyTreelet {
    std::atomic<const Treelet*> built = nullptr;
    std::once_flag flag;
    TreeletPart part;
    std::shared_ptr<const Treelet> owned;
    std::shared_ptr<const Treelet> inherited;
  };

  void set_top(WideTop top);
  const Treelet& build(std::uint32_t index, TreeletCounts& counts) const;

  LocalFrame frame_;
  FloatBox box_;
  const CornerSource& source_;
  WideTop top_;               ///< the top without what parts inherit, which is with the treelets
  mutable std::mutex mutex_;  ///< guards what stock() reads: the order, and what treelets own
  mutable std::vector<std::uint32_t>
      primitives_;  ///< the primitives; those of a treelet are in order once it is built
  std::unique_ptr<LazyTreelet[]> treelets_;
  std::size_t treelet_count_ = 0;
};

}  // namespace graze::bvh
