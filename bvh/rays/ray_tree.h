#pragma once

#include <graze/bvh/tree/tree.h>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace graze::bvh {

/// Up to eight boxes, as a ray asks for them: each in six bytes, on a grid of the node's own. Lane
/// j of each array speaks of child j, whose box reaches from origin[k] + scale[k] box[k][j] to
/// origin[k] + scale[k] box[k + 3][j] along axis k, and holds what the child holds (law 5).
///
/// Behind a node lie the corners of those of its children that are leaves, so that what a ray reads
/// after the node is in the same page.
struct alignas(64) RayNode {
  static constexpr std::uint32_t kWidth = 8;

  float origin[3];
  float scale[3];                ///< powers of two
  std::uint32_t child[kWidth];   ///< where a node is, or of a leaf the first place
  std::uint8_t box[6][kWidth];   ///< least, then largest values
  std::uint8_t in_leaf[kWidth];  ///< primitives of a leaf; 0 for a node
  std::uint8_t before[kWidth];   ///< primitives of this node's leaves before that one
  std::uint8_t child_count;      ///< at least 1

  /// The bits of the lanes that hold a child.
  std::uint32_t lanes() const { return (1u << child_count) - 1u; }

  /// A leaf's primitives: corner c of its primitive i is at c in_leaf[lane] + i, in ten bits for
  /// each coordinate, the first one lowest: steps of the grid across the leaf's box, to the
  /// nearest.
  const std::uint32_t* corners(std::uint32_t lane) const {
    return reinterpret_cast<const std::uint32_t*>(this + 1) + std::size_t{3} * before[lane];
  }
};
static_assert(sizeof(RayNode) == 128, "two cache lines");

/// Where a RayTree gets its primitives from, each as the hull of three points.
class LocalCorners {
 public:
  virtual ~LocalCorners() = default;

  /// The corners in the tree's frame, each coordinate off by a few roundings to double.
  virtual void of(std::uint32_t primitive, double (&corners)[3][3]) const = 0;
};

/// A binary tree collapsed for rays: nodes of eight boxes, leaves of up to eight primitives, which
/// lie in the binary tree's order, so that place i is primitive `tree.primitives[i]`. 12 bytes a
/// primitive, and with the nodes up to 20.
struct RayTree {
  static constexpr std::uint32_t kLeafSize = 8;
  static constexpr std::uint32_t kBits = 10;
  static constexpr std::uint32_t kSteps = (1u << kBits) - 1;

  /// A cache line: the unit in which children are counted.
  struct alignas(64) Line {
    std::byte bytes[64];
  };

  /// Frees what large_pages() made.
  struct LargePages {
    void operator()(Line* lines) const;
  };

  LocalFrame frame;
  alignas(32) double low[4];  ///< of the box of all, and a lane that nobody asks
  alignas(32) double high[4];
  std::unique_ptr<Line[], LargePages> lines;  ///< nodes, each with its leaves; the root first
  std::size_t line_count;           ///< with room behind all to read eight corners at once
  std::uint32_t most_open;          ///< nodes that can wait at once in a walk
  const std::uint32_t* primitives;  ///< the binary tree's, place by place

  const RayNode& node(std::uint32_t line) const {
    return *reinterpret_cast<const RayNode*>(lines.get() + line);
  }
  std::size_t bytes() const { return line_count * sizeof(Line); }
};

/// Linear time, the most of it parallel.
RayTree ray_tree_over(const Tree& tree, const LocalCorners& corners);

}  // namespace graze::bvh
