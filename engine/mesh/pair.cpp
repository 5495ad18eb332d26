#include <graze/bvh/box_pair_test.h>
#include <graze/bvh/traverse_pair.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/relative_frame.h>
#include <graze/narrowphase/triangle_triangle.h>

#include <algorithm>

namespace graze {
namespace {

bool meet(const Triangle& triangle_a, const Triangle& triangle_b, Work& work) {
  using narrowphase::Verdict;
  ++work.triangle_tests;
  const Verdict verdict = narrowphase::triage(triangle_a, triangle_b);
  if (verdict != Verdict::Unsure) return verdict == Verdict::Touching;
  ++work.exact_tests;
  return narrowphase::intersects_exactly(triangle_a, triangle_b);
}

/// Calls `on_pair(a, b)` with the indices of each pair of triangles that meet, until it answers
/// Stop.
template <typename OnPair>
void for_each_pair(const PlacedMesh& a, const PlacedMesh& b, Work& work, OnPair&& on_pair) {
  const double deviation_a = check_placement(a.pose, a.mesh.bounds(), "pose of mesh A");
  const double deviation_b = check_placement(b.pose, b.mesh.bounds(), "pose of mesh B");
  const bvh::Tree& tree_a = a.mesh.tree(&work);
  const bvh::Tree& tree_b = b.mesh.tree(&work);
  const bvh::BoxPairTest box_test(
      relative_frame({a.pose, deviation_a, tree_a.frame, a.mesh.bounds()},
                     {b.pose, deviation_b, tree_b.frame, b.mesh.bounds()}));
  const auto are_apart = [&](const bvh::Node& node_a, const bvh::Node& node_b) {
    ++work.volume_tests;
    const bool is_pruned = box_test.are_apart(node_a.box, node_b.box);
    work.volume_rejections += is_pruned;
    return is_pruned;
  };
  const auto is_first_larger = [&](const bvh::Node& node_a, const bvh::Node& node_b) {
    return box_test.is_first_larger(node_a.box, node_b.box);
  };
  const auto test_leaves = [&](const bvh::Node& leaf_a, const bvh::Node& leaf_b) {
    for (std::uint32_t i = leaf_a.first; i < leaf_a.first + leaf_a.count; ++i) {
      const std::uint32_t index_a = tree_a.primitives[i];
      const Triangle triangle_a = place(a.pose, a.mesh.triangle(index_a));
      for (std::uint32_t j = leaf_b.first; j < leaf_b.first + leaf_b.count; ++j) {
        const std::uint32_t index_b = tree_b.primitives[j];
        if (!meet(triangle_a, place(b.pose, b.mesh.triangle(index_b)), work)) continue;
        if (on_pair(index_a, index_b) == bvh::Walk::Stop) return bvh::Walk::Stop;
      }
    }
    return bvh::Walk::Continue;
  };
  bvh::traverse_pair(tree_a, tree_b, are_apart, is_first_larger, test_leaves);
}

}  // namespace

bool intersects(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b, Work* work) {
  Work counted;
  bool has_pair = false;
  for_each_pair(mesh_a, mesh_b, counted, [&](std::uint32_t, std::uint32_t) {
    has_pair = true;
    return bvh::Walk::Stop;
  });
  if (work != nullptr) *work += counted;
  return has_pair;
}

TrianglePairs find_triangle_pairs(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b,
                                  const PairSettings& settings, Work* work) {
  Work counted;
  TrianglePairs found;
  for_each_pair(mesh_a, mesh_b, counted, [&](std::uint32_t a, std::uint32_t b) {
    if (found.pairs.size() == settings.limit) {
      found.completeness = Completeness::LimitReached;
      return bvh::Walk::Stop;
    }
    found.pairs.push_back({a, b});
    return bvh::Walk::Continue;
  });
  std::sort(found.pairs.begin(), found.pairs.end());
  if (work != nullptr) *work += counted;
  return found;
}

}  // namespace graze
