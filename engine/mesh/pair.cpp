#include <graze/bvh/traverse_pair.h>
#include <graze/bvh/wide/wide_pair_walk.h>
#include <graze/engine/mesh/node_volumes.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/parity.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query_results.h>
#include <graze/engine/mesh/relative_frame.h>
#include <graze/engine/mesh/solid.h>
#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/triangle_pair_batch.h>

#include <bit>

namespace graze {
namespace {

/// Candidates on their way from the trees to the triangle tests.
class Candidates {
 public:
  Candidates(Touch touch, Work& work) : touch_(touch), work_(work) {}

  bool is_full() const { return batch_.is_full(); }

  void add(TrianglePair pair, const Triangle& triangle_a, const Triangle& triangle_b) {
    pairs_[batch_.size()] = pair;
    batch_.add(triangle_a, triangle_b);
  }

  /// Empties the batch: calls `on_pair(pair)` for each pair that meets, until it answers Stop.
  template <typename OnPair>
  bvh::Walk decide(OnPair&& on_pair) {
    const std::size_t size = batch_.size();
    const narrowphase::Verdicts verdicts = narrowphase::triage(batch_);
    batch_.clear();
    work_.triangle_tests += size;
    // Lanes of two that surely cross count as touching, too.
    std::uint32_t open = ((1u << size) - 1) & ~verdicts.apart;
    while (open != 0) {
      const int i = std::countr_zero(open);
      open &= open - 1;
      const bool is_sure = (verdicts.touching >> i & 1) != 0;
      if (!is_sure && !meet(batch_.triangle_a(i), batch_.triangle_b(i))) continue;
      if (on_pair(pairs_[i]) == bvh::Walk::Stop) return bvh::Walk::Stop;
    }
    return bvh::Walk::Continue;
  }

 private:
  bool meet(const Triangle& triangle_a, const Triangle& triangle_b) {
    const narrowphase::Decision decision = narrowphase::decide(triangle_a, triangle_b, touch_);
    work_.exact_tests += decision.stage == narrowphase::Stage::Exact;
    return decision.is_hit;
  }

  Touch touch_;
  Work& work_;
  narrowphase::TrianglePairBatch batch_;
  TrianglePair pairs_[narrowphase::TrianglePairBatch::kCapacity];
};

/// for_each_pair() by wide trees whose boxes as a whole are not apart.
template <typename OnPair>
void walk_wide_trees(const PlacedMesh& a, const PlacedMesh& b, const bvh::RelativeFrame& b_in_a,
                     const bvh::RelativeFrame& a_in_b, Touch touch, Work& work, OnPair&& on_pair) {
  const bvh::WideTree& tree_a = a.mesh.wide_tree();
  const bvh::WideTree& tree_b = b.mesh.wide_tree();
  bvh::WidePairWalk walk(tree_a, tree_b, b_in_a, a_in_b);
  Candidates candidates(touch, work);
  bvh::PlacePair places[bvh::WidePairWalk::kMostAtOnce + narrowphase::TrianglePairBatch::kCapacity];
  bool is_stopped = false;
  while (!is_stopped) {
    const std::size_t count = walk.next(places);
    if (count == 0) break;
    for (std::size_t i = 0; i < count && !is_stopped; ++i) {
      const std::uint32_t index_a = tree_a.primitive(places[i].a);
      const std::uint32_t index_b = tree_b.primitive(places[i].b);
      candidates.add({index_a, index_b}, place(a.pose, a.mesh.triangle(index_a)),
                     place(b.pose, b.mesh.triangle(index_b)));
      is_stopped = candidates.is_full() && candidates.decide(on_pair) == bvh::Walk::Stop;
    }
  }
  if (!is_stopped) candidates.decide(on_pair);
  work.volume_tests += walk.counts().box_tests;
  work.volume_rejections += walk.counts().box_rejections;
  work.treelets_built += walk.counts().treelets_built;
  work.filter_tests += walk.counts().primitive_tests;
}

/// for_each_pair() by wide trees. Far apart is the common case, which is over after one test.
template <typename OnPair>
void for_each_wide_pair(const PlacedMesh& a, const PlacedMesh& b, Touch touch, Work& work,
                        OnPair&& on_pair) {
  const double deviation_a = check_placement(a.pose, a.mesh.bounds(), "pose of mesh A");
  const double deviation_b = check_placement(b.pose, b.mesh.bounds(), "pose of mesh B");
  const bvh::WideTree& tree_a = a.mesh.wide_tree(&work);
  const bvh::WideTree& tree_b = b.mesh.wide_tree(&work);
  const PlacedFrame frame_a{a.pose, deviation_a, tree_a.frame(), a.mesh.bounds()};
  const PlacedFrame frame_b{b.pose, deviation_b, tree_b.frame(), b.mesh.bounds()};
  const bvh::RelativeFrame b_in_a = relative_frame(frame_a, frame_b);
  ++work.volume_tests;
  if (bvh::BoxSeparation(b_in_a).are_apart(tree_a.box(), tree_b.box())) {
    ++work.volume_rejections;
    return;
  }
  walk_wide_trees(a, b, b_in_a, relative_frame(frame_b, frame_a), touch, work, on_pair);
}

/// Calls `on_pair(pair)` with the indices of each pair of triangles that meet, until it answers
/// Stop.
template <typename OnPair>
void for_each_pair(const PlacedMesh& a, const PlacedMesh& b, const PairSettings& settings,
                   Work& work, OnPair&& on_pair) {
  narrowphase::check_touch(settings.touch);
  if (settings.volume == Volume::Wide)
    return for_each_wide_pair(a, b, settings.touch, work, on_pair);
  const double deviation_a = check_placement(a.pose, a.mesh.bounds(), "pose of mesh A");
  const double deviation_b = check_placement(b.pose, b.mesh.bounds(), "pose of mesh B");
  const NodeVolumes volumes_a = volumes_of(a.mesh, settings.volume, work);
  const NodeVolumes volumes_b = volumes_of(b.mesh, settings.volume, work);
  const bvh::Tree& tree_a = a.mesh.tree();
  const bvh::Tree& tree_b = b.mesh.tree();
  const bvh::RelativeFrame frame =
      relative_frame({a.pose, deviation_a, tree_a.frame, a.mesh.bounds()},
                     {b.pose, deviation_b, tree_b.frame, b.mesh.bounds()});
  Candidates candidates(settings.touch, work);
  const auto collect = [&](const bvh::Node& leaf_a, const bvh::Node& leaf_b) {
    for (std::uint32_t i = leaf_a.first; i < leaf_a.first + leaf_a.count; ++i) {
      const std::uint32_t index_a = tree_a.primitives[i];
      const Triangle triangle_a = place(a.pose, a.mesh.triangle(index_a));
      for (std::uint32_t j = leaf_b.first; j < leaf_b.first + leaf_b.count; ++j) {
        const std::uint32_t index_b = tree_b.primitives[j];
        candidates.add({index_a, index_b}, triangle_a, place(b.pose, b.mesh.triangle(index_b)));
        if (candidates.is_full() && candidates.decide(on_pair) == bvh::Walk::Stop)
          return bvh::Walk::Stop;
      }
    }
    return bvh::Walk::Continue;
  };
  with_separation(settings.volume, frame, volumes_a, volumes_b, [&](const auto& separation) {
    const CountedSeparation counted(separation, work);
    const bvh::Walk walk = bvh::traverse_pair(tree_a, tree_b, counted, collect);
    if (walk == bvh::Walk::Continue) candidates.decide(on_pair);
  });
}

}  // namespace

bool intersects(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b, Work* work) {
  return intersects(mesh_a, mesh_b, QuerySettings{}, work);
}

bool intersects(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b, const QuerySettings& settings,
                Work* work) {
  check_interior(settings);
  if (settings.interior == Interior::Solid) {
    check_closed(mesh_a.mesh, "mesh A");
    check_closed(mesh_b.mesh, "mesh B");
  }
  CountedWork counted(work);
  const bool is_touching = has_any([&](auto&& on_pair) {
    for_each_pair(mesh_a, mesh_b, {.volume = settings.volume, .touch = settings.touch},
                  counted.work(), on_pair);
  });
  return is_touching ||
         (settings.interior == Interior::Solid && is_either_inside(mesh_a, mesh_b, counted.work()));
}

TrianglePairs find_triangle_pairs(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b,
                                  const PairSettings& settings, Work* work) {
  CountedWork counted(work);
  TrianglePairs found;
  found.completeness = collect(found.pairs, settings.limit, [&](auto&& on_pair) {
    for_each_pair(mesh_a, mesh_b, settings, counted.work(), on_pair);
  });
  return found;
}

}  // namespace graze
