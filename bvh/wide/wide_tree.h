#pragma once

#include <graze/bvh/local_frame.h>
#include <graze/bvh/reference.h>
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

  virtual std::size_t size() const = 0;

  /// References to these primitives, with their boxes rounded outward in the frame; to all of them,
  /// in parallel, if none are named.
  virtual References references(const LocalFrame& frame,
                                std::span<const std::uint32_t> primitives = {}) const = 0;

  /// Fills `rows`, which is as long, with these primitives' corners: in the frame, less `origin`.
  virtual void fill(std::span<const std::uint32_t> primitives, const LocalFrame& frame,
                    const double (&origin)[3], CornerRows& rows) const = 0;
};

/// A child of a node, by where the node stands: everything that a walk has to remember of it.
struct WideSlot {
  const WideNode* node;
  std::uint32_t lane;
  std::uint32_t treelet;
  bool operator==(const WideSlot&) const = default;
};

/// The one topology collapsed to wide nodes. Its top is built at once, the treelets below it, of
/// two thousand primitives at most, when a walk first enters them: a tree that is asked little is
/// built little. Safe to walk from many threads; the same nodes whenever and by whomever they are
/// built.
class WideTree {
 public:
  /// Nodes, the primitives that their leaves count from, and these primitives' corners: in the
  /// tree's frame less an origin of the treelet's own, so that floats tell points apart that are
  /// close for the treelet, however large the tree.
  struct Treelet {
    std::vector<WideNode> nodes;
    std::vector<float> corners;  // of a leaf: 9 rows, one behind the other, from 9 * its first on
    double origin[3] = {0, 0, 0};
    float reach = 0;  // no coordinate of a corner is larger in size
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    int depth = 0;  // binary nodes above
  };

  /// Builds the top, in parallel. The source must outlive the tree; `bounds` holds all of it.
  WideTree(const Aabb& bounds, const CornerSource& source);

  const LocalFrame& frame() const { return frame_; }

  /// The box of everything.
  const FloatBox& box() const { return box_; }

  /// Where walks begin: the box of everything.
  WideSlot root() const { return {treelet(0).nodes.data(), 0, 0}; }

  /// A treelet that has been built: the first is the top.
  const Treelet& treelet(std::uint32_t index) const { return treelets_[index].treelet; }

  /// A treelet, which is built if this is the first time that it is asked for, and then counted.
  const Treelet& entered(std::uint32_t index, std::uint64_t& built) const;

  /// Builds all that is not built yet, in parallel. Returns how many treelets that was.
  std::size_t build_all() const;

  /// The primitive at this place in the order of the leaves. Its treelet must have been built.
  std::uint32_t primitive(std::uint32_t place) const { return primitives_[place]; }

  std::size_t treelet_count() const { return treelet_count_; }
  bool is_built(std::uint32_t index) const {
    return treelets_[index].is_built.load(std::memory_order_acquire);
  }

  /// Of what has been built so far.
  std::size_t bytes() const;

 private:
  struct LazyTreelet {
    mutable std::atomic<bool> is_built = false;
    mutable std::once_flag flag;
    mutable Treelet treelet;
  };

  void build(std::uint32_t index, std::uint64_t& built) const;

  LocalFrame frame_;
  FloatBox box_;
  const CornerSource& source_;
  mutable std::vector<std::uint32_t> primitives_;  // of a treelet in order when it has been built
  std::unique_ptr<LazyTreelet[]> treelets_;
  std::size_t treelet_count_ = 0;
};

}  // namespace graze::bvh
