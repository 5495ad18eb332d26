#pragma once

#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/sweep/cast_directions.h>

#include <array>
#include <cstdint>

namespace graze::contacts {

/// What the nodes and triangles of one tree are along the directions of a cast. What was asked last
/// is kept, without any allocation: a walk meets the same node some ten times.
class CastNodes {
 public:
  using Span = CastDirections::Span;
  using Side = CastDirections::Side;

  /// The triangles of a leaf, placed.
  struct Leaf {
    std::array<Triangle, 4> triangle;
    std::array<Span, 4> span;
  };

  CastNodes(Side side, const FramedMesh& mesh, const bvh::Tree& tree,
            const CastDirections& directions)
      : side_(side), mesh_(mesh), tree_(tree), directions_(directions) {
    forget();
  }

  /// Around the box of a node, or the triangles of a leaf.
  const Span& span_of(std::uint32_t node);
  /// Of a leaf; until the next call.
  const Leaf& leaf(std::uint32_t node);

  /// To be called when the directions have changed.
  void forget() {
    node_at_.fill(kNone);
    leaf_at_.fill(kNone);
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  static constexpr std::uint32_t kNodes = 512;
  static constexpr std::uint32_t kLeaves = 128;

  Side side_;
  FramedMesh mesh_;
  const bvh::Tree& tree_;
  const CastDirections& directions_;
  std::array<std::uint32_t, kNodes> node_at_;
  std::array<std::uint32_t, kLeaves> leaf_at_;
  std::array<Span, kNodes> span_;
  std::array<Leaf, kLeaves> leaf_;
};

}  // namespace graze::contacts
