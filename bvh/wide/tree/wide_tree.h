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
  std::uint16_t count;  ///< of children, at least 1
  std::uint16_t
      has_slabs;  ///< whether slabs are so much thinner than boxes that it pays to ask them
  double origin[3];
  std::uint32_t child[kWidth];      ///< as ChildLink packs them
  std::int8_t slope[2][kWidth];     ///< q stands for q |q| 2^-14: finer where it is small
  std::int8_t slab_middle[kWidth];  ///< in 2^-7 h
  std::uint8_t slab_half[kWidth];   ///< in 2^-8 h, less one

  /// What slopes are in the end: between -1 and 1, and exact.
  static float slope_of(std::int8_t q) {
    return static_cast<float>(q) * static_cast<float>(q < 0 ? -q : q) * kSlopeUnit;
  }

  static constexpr float kSlopeUnit = 0x1p-14f;
  static constexpr float kSlabMiddleUnit = 0x1p-7f;
  static constexpr float kSlabHalfUnit = 0x1p-8f;

  /// The bits of the lanes that hold a child.
  std::uint32_t lanes() const { return (1u << count) - 1u; }
};
static_assert(sizeof(WideNode) == 320, "five cache lines");

/// What a lane of a node leads to: a node so many behind this one, another treelet, or a leaf,
/// whose primitives are counted from the treelet's first on.
struct ChildLink {
  static constexpr std::uint32_t kMaxLeafSize = 4;

  enum class Kind : std::uint32_t { Node, Treelet, Leaf };

  static std::uint32_t to_node(std::uint32_t behind) { return behind; }
  static std::uint32_t to_treelet(std::uint32_t index) { return kTreeletBit | index; }
  static std::uint32_t to_leaf(std::uint32_t first, std::uint32_t count) {
    return kLeafBit | (first << kCountBits) | (count - 1);
  }

  static bool is_leaf(std::uint32_t link) { return (link & kLeafBit) != 0; }
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

/// Which primitives, by their places in a wide tree's order, are those of a treelet, and where they
/// lie.
struct TreeletPart {
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  int depth = 0;  ///< binary nodes above
  FloatBox box;
};

/// Nodes, the primitives that their leaves count from, and these primitives' corners: in the tree's
/// frame less an origin of the treelet's own, so that floats tell points apart that are close for
/// the treelet, however large the tree.
struct Treelet {
  std::vector<WideNode> nodes;
  std::vector<float> corners;  ///< of a leaf: 9 rows, one behind the other, from 9 * its first on
  double origin[3] = {0, 0, 0};
  float largest_coordinate = 0;  ///< no coordinate of a corner is larger, nor its negative
  std::uint32_t first = 0;

  // cost_of() the nodes when they were built, and when their axes were last chosen.
  float built_cost = 0;
  float fitted_cost = 0;
};

/// How treelets came to be.
struct TreeletCounts {
  std::uint64_t built = 0;     ///< from primitives alone
  std::uint64_t refitted = 0;  ///< from the nodes of an earlier tree
};

/// The binary nodes above the treelets. A leaf among them is a treelet: its `first` counts parts,
/// its `count` primitives.
struct WideTop {
  std::vector<Node> nodes;
  std::vector<float> costs;  ///< subtree_costs() when each node was built
  std::vector<TreeletPart> parts;
  // Of each part what an earlier tree made of the same primitives in the same order, if anything.
  std::vector<std::shared_ptr<const Treelet>> inherited;
};

/// What is left of a wide tree for the next one over the same primitives, elsewhere.
struct WideStock {
  WideTop top;
  std::vector<std::uint32_t> primitives;
};

/// A child of a node, by where the node stands: everything that a walk has to remember of it.
struct WideChildRef {
  const WideNode* node;
  std::uint32_t lane;
  std::uint32_t treelet;
  bool operator==(const WideChildRef&) const = default;
};

/// The one topology collapsed to wide nodes. Its top is built at once, the treelets below it, of
/// two thousand primitives at most, when a walk first enters them: a tree that is asked little is
/// built little. Safe to walk from many threads; the same nodes whenever and by whomever they are
/// built.
class WideTree {
 public:
  using Treelet = bvh::Treelet;

  /// Builds the top, in parallel. The source must outlive the tree; `bounds` holds all of it.
  WideTree(const Aabb& bounds, const CornerSource& source);

  /// Over the primitives of the tree that left the stock, which may have moved anywhere: refits the
  /// top, in parallel, and later treelets as they are entered. What has degraded is built anew.
  WideTree(const Aabb& bounds, const CornerSource& source, const WideStock& stock);

  /// What the next tree over these primitives can begin with: copies a few bytes a primitive, and
  /// shares treelets. Safe beside walks.
  WideStock stock() const;

  const LocalFrame& frame() const { return frame_; }

  /// The box of everything.
  const FloatBox& box() const { return box_; }

  /// Where walks begin: the box of everything.
  WideChildRef root() const { return {treelet(0).nodes.data(), 0, 0}; }

  /// A treelet that has been built: the first is the top.
  const Treelet& treelet(std::uint32_t index) const {
    return *treelets_[index].built.load(std::memory_order_acquire);
  }

  /// A treelet, which is built if this is the first time that it is asked for, and then counted.
  const Treelet& entered(std::uint32_t index, TreeletCounts& counts) const;

  /// Builds all that is not built yet, in parallel. Returns how many treelets that was.
  TreeletCounts build_all() const;

  /// The primitive at this place in the order of the leaves. Its treelet must have been built.
  std::uint32_t primitive(std::uint32_t place) const { return primitives_[place]; }

  std::size_t treelet_count() const { return treelet_count_; }
  bool is_built(std::uint32_t index) const {
    return treelets_[index].built.load(std::memory_order_acquire) != nullptr;
  }

  /// Of what has been built so far.
  std::size_t bytes() const;

 private:
  /// `built` is set last, and once. What is inherited serves to build the treelet, and is then
  /// given up.
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
  WideTop top_;               ///< without what parts inherit, which is with the treelets
  mutable std::mutex mutex_;  ///< guards what stock() reads: the order, and what treelets own
  mutable std::vector<std::uint32_t>
      primitives_;  ///< those of a treelet are in order once it is built
  std::unique_ptr<LazyTreelet[]> treelets_;
  std::size_t treelet_count_ = 0;
};

}  // namespace graze::bvh
