#pragma once

#include <graze/bvh/value/local_frame.h>
#include <graze/bvh/wide/tree/corner_source.h>
#include <graze/bvh/wide/tree/treelet.h>
#include <graze/bvh/wide/tree/wide_node.h>
#include <graze/bvh/wide/tree/wide_top.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace graze::bvh {

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
