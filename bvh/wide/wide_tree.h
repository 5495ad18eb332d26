#pragma once

#include <graze/bvh/local_frame.h>
#include <graze/bvh/wide/corner_rows.h>
#include <graze/bvh/wide/wide_node.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace graze::bvh {

/// Where a WideTree gets its primitives from, each as the hull of three points.
class CornerSource {
 public:
  virtual ~CornerSource() = default;

  /// Fills `rows`, which is as long, with these primitives' corners: in the frame, less `origin`.
  virtual void fill(std::span<const std::uint32_t> primitives, const LocalFrame& frame,
                    const double (&origin)[3], CornerRows& rows) const = 0;
};

/// A child of a node, by where the node stands: everything that a walk has to remember of it.
struct WideSlot {
  std::uint32_t treelet;
  std::uint32_t lane;  // node * WideNode::kWidth + its lane
  bool operator==(const WideSlot&) const = default;
};

/// The one topology collapsed to wide nodes. Built in treelets of a few thousand primitives, each
/// when a walk first enters it: a tree that is asked little is built little. Safe to walk from many
/// threads.
class WideTree {
 public:
  /// Nodes, the primitives that their leaves count from, and these primitives' corners. Coordinates
  /// are those of the tree's frame less an origin of the treelet's own: floats then tell points
  /// apart that are close for the treelet, however large the tree.
  struct Treelet {
    std::vector<WideNode> nodes;
    std::vector<float> corners;  // of a leaf: 9 rows, one behind the other, from 9 * its first on
    double origin[3] = {0, 0, 0};
    float reach = 0;  // no coordinate of a corner is larger in size
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };

  /// Where walks begin: the box of everything.
  static constexpr WideSlot kRoot = {0, 0};

  WideTree(const Aabb& bounds, std::size_t primitives, const CornerSource& source);

  const LocalFrame& frame() const { return frame_; }

  /// The box of everything.
  const FloatBox& box() const { return box_; }

  /// The nodes of a treelet, which is built if this is the first time that they are asked for.
  const Treelet& treelet(std::uint32_t index) const {
    const LazyTreelet& lazy = treelets_[index];
    if (!lazy.is_built.load(std::memory_order_acquire)) build(index);
    return lazy.treelet;
  }

  /// The primitive at this place in the order of the leaves. Its treelet must have been built.
  std::uint32_t primitive(std::uint32_t place) const { return primitives_[place]; }

  std::size_t treelet_count() const { return treelet_count_; }
  std::size_t built_treelets() const;

  /// Of the nodes built so far and of the primitives' indices.
  std::size_t bytes() const;

 private:
  struct LazyTreelet {
    mutable std::atomic<bool> is_built = false;
    mutable std::once_flag flag;
    mutable Treelet treelet;
  };

  void build(std::uint32_t index) const;
  void build_nodes(Treelet& treelet) const;

  LocalFrame frame_;
  FloatBox box_;
  const CornerSource& source_;
  mutable std::vector<std::uint32_t>
      primitives_;  // each treelet's are put in order when it is built
  std::unique_ptr<LazyTreelet[]> treelets_;
  std::size_t treelet_count_ = 0;
};

}  // namespace graze::bvh
