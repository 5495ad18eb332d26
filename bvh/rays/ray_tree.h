#pragma once

#include <graze/bvh/tree/tree.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace graze::bvh {

/// The contents of a lane of a RayNode: another node, where a RayTree has it, or a leaf of up to
/// eight primitives, which `place()` tells (RayLeaves).
class RayChild {
 public:
  static constexpr std::uint32_t kPlaceBits = 28;
  static constexpr std::size_t kMostPlaces = std::size_t{1} << kPlaceBits;

  static RayChild node(std::uint32_t where) { return RayChild(where); }
  static RayChild leaf(std::uint32_t place, std::uint32_t count) {
    return RayChild(kLeaf | (count - 1) << kPlaceBits | place);
  }

  bool is_leaf() const { return bits_ >= kLeaf; }
  std::uint32_t where() const { return bits_; }
  std::uint32_t count() const { return (bits_ >> kPlaceBits & 7) + 1; }
  std::uint32_t place() const { return bits_ & ((1u << kPlaceBits) - 1); }

 private:
  static constexpr std::uint32_t kLeaf = 1u << 31;

  explicit RayChild(std::uint32_t bits) : bits_(bits) {}

  std::uint32_t bits_;
};

/// A wide node of up to eight boxes, as a ray is compared with them. Lane j of each row speaks of
/// child j, whose box (law 5) reaches from box[2 k][j] to box[2 k + 1][j] along axis k. Boxes of
/// lanes without a child are empty.
struct alignas(32) RayNode {
  static constexpr std::uint32_t kWidth = 8;

  float box[6][kWidth];
  RayChild child[kWidth];
};
static_assert(sizeof(RayNode) == 224, "seven half cache lines");

/// The source of a RayTree's primitives, each as the hull of three points.
class LocalCorners {
 public:
  virtual ~LocalCorners() = default;

  /// Writes the corners in the tree's frame, each coordinate off by a few roundings to double.
  virtual void of(std::uint32_t primitive, double (&corners)[3][3]) const = 0;

  /// Returns the numbers of each primitive's corners, if there are any. What has one number is one
  /// point.
  virtual std::span<const std::array<std::uint32_t, 3>> numbers() const { return {}; }
};

/// Says how the leaves of a RayTree lie in its memory. A point is ten bits for each coordinate, the
/// first one lowest: steps of the grid across the leaf's box, to the nearest.
enum class RayLeaves {
  /// In a leaf of n primitives from place p on, corner c of its primitive i is the point at 3 p + c
  /// n + i.
  Corners,
  /// A leaf is a SharedPoints, whose word its child tells. Neighbours share points, so that there
  /// is room for the points' numbers, by which a primitive's corners are found sooner.
  SharedPoints,
};

/// The beginning of a leaf whose primitives share points. Its points follow, then their numbers.
class SharedPoints {
 public:
  static constexpr std::uint32_t kMost = 16;
  static constexpr std::uint32_t kBits = 4;
  static constexpr std::size_t kHeader = 4;  ///< the words before the points

  static std::size_t words(std::uint32_t count) { return kHeader + 2 * std::size_t{count}; }

  SharedPoints(std::uint32_t place, std::uint32_t count)
      : place_and_count_((count - 1) << RayChild::kPlaceBits | place) {}

  std::uint32_t place() const { return place_and_count_ & (RayChild::kMostPlaces - 1); }
  std::uint32_t count() const { return (place_and_count_ >> RayChild::kPlaceBits) + 1; }

  /// Returns which of the points is corner c of each primitive, kBits for each.
  std::uint32_t corners(std::uint32_t c) const { return corners_[c]; }
  std::uint32_t corner(std::uint32_t primitive, std::uint32_t c) const {
    return corners_[c] >> (kBits * primitive) & (kMost - 1);
  }
  void set(std::uint32_t primitive, std::uint32_t c, std::uint32_t point) {
    corners_[c] |= point << (kBits * primitive);
  }

 private:
  std::uint32_t place_and_count_;  ///< the count less 1 above the place
  std::uint32_t corners_[3] = {};
};
static_assert(sizeof(SharedPoints) == SharedPoints::kHeader * sizeof(std::uint32_t));

/// A binary tree collapsed for rays: nodes of eight boxes, leaves of up to eight primitives, which
/// lie in the binary tree's order, so that place i is primitive `tree.primitives[i]`. Where
/// there are thousands of primitives it takes up to 20 bytes for each, twelve to thirteen of them
/// for the leaves.
struct RayTree {
  static constexpr std::uint32_t kLeafSize = 8;
  static constexpr std::uint32_t kBits = 10;
  static constexpr std::uint32_t kSteps = (1u << kBits) - 1;
  /// The words behind the leaves that may be read: all points that a leaf can have.
  static constexpr std::size_t kRoom = SharedPoints::kHeader + SharedPoints::kMost;
  /// The words that a primitive may take with the nodes where leaves share points.
  static constexpr std::size_t kMostWords = 5;

  /// The bytes in which the place of a node is counted: half a cache line.
  static constexpr std::size_t kUnit = 32;
  /// The largest number of nodes: a walk keeps 29 bits of a node's place, beside a lane.
  static constexpr std::size_t kMostNodes = (std::size_t{1} << 29) / (sizeof(RayNode) / kUnit);
  static std::uint32_t where(std::size_t node) {
    return static_cast<std::uint32_t>(node * (sizeof(RayNode) / kUnit));
  }
  const RayNode& node(std::uint32_t where) const {
    const auto* bytes = reinterpret_cast<const std::byte*>(nodes.get());
    return *reinterpret_cast<const RayNode*>(bytes + std::size_t{where} * kUnit);
  }

  /// Returns where a leaf begins among the words of all. Of a node it is a number without meaning.
  std::size_t first_word(RayChild leaf) const {
    return (leaves == RayLeaves::SharedPoints ? std::size_t{1} : std::size_t{3}) * leaf.place();
  }
  const std::uint32_t* leaf(RayChild child) const { return corners.get() + first_word(child); }

  /// Frees what is in large pages.
  struct LargePages {
    void operator()(void* made) const;
  };

  LocalFrame frame;
  alignas(32) double low[4];  ///< the least coordinates of the box of all, and a lane that stands
                              ///< for nothing
  alignas(32) double high[4];
  /// The nodes. The first is in front of the root, which is its only child.
  std::unique_ptr<RayNode[], LargePages> nodes;
  RayLeaves leaves;
  /// The leaves, and behind them room to read all of the points that one may have.
  std::unique_ptr<std::uint32_t[], LargePages> corners;
  std::size_t node_count;           ///< 0 where a RayChild cannot name all that there is
  std::size_t corner_count;         ///< the words of the leaves, with that room
  std::uint32_t most_open;          ///< how many nodes can wait at once in a walk
  const std::uint32_t* primitives;  ///< the binary tree's, place by place

  std::size_t bytes() const {
    return node_count * sizeof(RayNode) + corner_count * sizeof(std::uint32_t);
  }
};

/// Returns the tree for rays over a binary tree, in linear time. What fills leaves is parallel.
RayTree ray_tree_over(const Tree& tree, const LocalCorners& corners);

}  // namespace graze::bvh
