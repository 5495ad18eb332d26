#pragma once

#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/sweep/cast_directions.h>
#include <graze/engine/work.h>

#include <array>
#include <cstdint>
#include <span>

namespace graze::contacts {

/// Measures the nodes and triangles of a mesh along the directions of a cast. What was asked last
/// is kept, without any allocation; where only the normal changes, only its pair is measured anew.
class CastNodes {
 public:
  using Span = CastDirections::Span;
  using Pairs = CastDirections::Pairs;

  /// The triangles of a leaf, placed.
  struct Leaf {
    std::array<Triangle, 4> triangle;
    std::array<Span, 4> span;
  };

  CastNodes(const FramedMesh& mesh, const bvh::Tree& tree, const CastDirections& directions,
            Work& work)
      : mesh_(mesh),
        tree_(tree),
        kdops_(kdop_skin_of(mesh.placed.mesh, &work)),
        directions_(directions) {
    for (Kept& kept : kept_)
      kept.node = kNone;
    leaf_at_.fill(kNone);
  }

  /// Returns the span of the k-DOP of a node, or of the triangles of a leaf. It is valid until the
  /// next call.
  const Span& span_of(std::uint32_t node) {
    const std::uint32_t at = node % kNodes;
    const Kept& kept = kept_[at];
    return kept.node == node && kept.normal == normal_ ? span_[at] : measured(node);
  }
  /// Returns the triangles of a leaf. They are valid until the next call.
  const Leaf& leaf(std::uint32_t node);

  /// Has to be called when the directions have taken another normal.
  void take_normal() { ++normal_; }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  static constexpr std::uint32_t kNodes = 512;
  static constexpr std::uint32_t kLeaves = 128;

  struct Kept {
    std::uint32_t node;
    std::uint32_t normal;  ///< the number of the normal that it was measured along
  };
  const Span& measured(std::uint32_t node);

  FramedMesh mesh_;
  const bvh::Tree& tree_;
  std::span<const bvh::FloatKDop> kdops_;
  const CastDirections& directions_;
  std::uint32_t normal_ = 0;  ///< how many normals there were before this one
  std::array<std::uint32_t, kLeaves> leaf_at_;
  std::array<std::uint32_t, kLeaves> leaf_normal_;
  std::array<Kept, kNodes> kept_;  ///< apart from the spans, so that little has to be cleared
  std::array<Span, kNodes> span_;
  std::array<Leaf, kLeaves> leaf_;
};

}  // namespace graze::contacts
