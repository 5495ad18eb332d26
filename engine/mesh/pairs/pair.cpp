#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/traverse/traverse_pair.h>
#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/inside/solid.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/pairs/parallel_pairs.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/placing/relative_frame.h>
#include <graze/engine/mesh/query/candidates.h>
#include <graze/engine/mesh/query/crossing_pairs.h>
#include <graze/engine/mesh/query/node_volumes.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/query/threads.h>
#include <graze/engine/mesh/query/wide_query.h>
#include <graze/narrowphase/crossing.h>

namespace graze {
namespace {

/// for_each_pair() by wide trees.
template <typename OnPair>
void for_each_wide_pair(const PlacedMesh& a, const PlacedMesh& b, Touch touch, Work& work,
                        OnPair&& on_pair) {
  const WideQuery query(a, b, work);
  if (query.are_far_apart(work)) return;
  bvh::WidePairWalk walk = query.walk();
  Candidates candidates(touch, work);
  query.decide_all(walk, candidates, on_pair);
  add_counts(walk.counts(), work);
}

bool has_wide_pair(const PlacedMesh& a, const PlacedMesh& b, Touch touch, Work& work) {
  narrowphase::check_touch(touch);
  const WideQuery query(a, b, work);
  if (query.are_far_apart(work)) return false;
  bvh::WidePairWalk walk = query.walk();
  Candidates candidates(touch, work);
  const bvh::Walk end =
      query.decide_at_once(walk, candidates, [](TrianglePair) { return bvh::Walk::Stop; });
  add_counts(walk.counts(), work);
  return end == bvh::Walk::Stop;
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
      const Triangle triangle_a = narrowphase::place(a.pose, a.mesh.triangle(index_a));
      for (std::uint32_t j = leaf_b.first; j < leaf_b.first + leaf_b.count; ++j) {
        const std::uint32_t index_b = tree_b.primitives[j];
        candidates.add({index_a, index_b}, triangle_a,
                       narrowphase::place(b.pose, b.mesh.triangle(index_b)));
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

bool is_unlimited(const PairSettings& settings) {
  return settings.limit == PairSettings{}.limit;
}

}  // namespace

bool intersects(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b, Work* work) {
  return intersects(mesh_a, mesh_b, QuerySettings{}, work);
}

bool intersects(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b, const QuerySettings& settings,
                Work* work) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    check_interior(settings);
    if (settings.interior == Interior::Solid) {
      check_closed(mesh_a.mesh, "mesh A");
      check_closed(mesh_b.mesh, "mesh B");
    }
    CountedWork counted(work);
    const bool is_touching =
        settings.volume == Volume::Wide
            ? has_wide_pair(mesh_a, mesh_b, settings.touch, counted.work())
            : has_any([&](auto&& on_pair) {
                for_each_pair(mesh_a, mesh_b, {.volume = settings.volume, .touch = settings.touch},
                              counted.work(), on_pair);
              });
    return is_touching || (settings.interior == Interior::Solid &&
                           is_either_inside(mesh_a, mesh_b, counted.work()));
  });
}

TrianglePairs find_triangle_pairs(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b,
                                  const PairSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> TrianglePairs {
    CountedWork counted(work);
    check_threads(settings.threads);
    TrianglePairs found;
    if (settings.threads != 1 && is_unlimited(settings) && settings.volume == Volume::Wide) {
      narrowphase::check_touch(settings.touch);
      const WideQuery query(mesh_a, mesh_b, counted.work());
      if (!query.are_far_apart(counted.work())) {
        found.pairs =
            find_pairs_in_parallel(query, settings.touch, settings.threads, counted.work());
      }
      return found;
    }
    found.completeness = collect(found.pairs, settings.limit, [&](auto&& on_pair) {
      for_each_pair(mesh_a, mesh_b, settings, counted.work(), on_pair);
    });
    return found;
  });
}

void find_triangle_pairs_into(std::vector<TrianglePair>& pairs, const PlacedMesh& mesh_a,
                              const PlacedMesh& mesh_b, Work& work) {
  pairs.clear();
  for_each_wide_pair(mesh_a, mesh_b, Touch::Include, work, [&](const TrianglePair& pair) {
    pairs.push_back(pair);
    return bvh::Walk::Continue;
  });
  std::sort(pairs.begin(), pairs.end());
}

}  // namespace graze
