#pragma once

#include <cstdint>

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

}  // namespace graze::bvh
