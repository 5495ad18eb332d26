#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/data/mesh_data.h>
#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/inside/solid.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/pairs/binary_pairs.h>
#include <graze/engine/mesh/pairs/parallel_pairs.h>
#include <graze/engine/mesh/query/candidates.h>
#include <graze/engine/mesh/query/pair_list.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/query/threads.h>
#include <graze/engine/mesh/query/wide_query.h>
#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/triangle_pair/crossing_stages.h>

#include <algorithm>

namespace graze {
namespace {

/// True if the balls around both prove that they are far apart: one test, and no tree is built.
bool are_balls_apart(const PlacedMeshView& a, const PlacedMeshView& b, Work* work) {
  const bool is_apart = are_surely_far_apart({a.pose, MeshAccess::data(a.mesh).ball},
                                             {b.pose, MeshAccess::data(b.mesh).ball});
  if (is_apart && work != nullptr) ++work->volume_tests, ++work->volume_rejections;
  return is_apart;
}

/// Does for_each_pair() by wide trees.
template <typename OnPair>
void for_each_wide_pair(const PlacedMeshView& a, const PlacedMeshView& b, Touch touch, Work& work,
                        OnPair&& on_pair) {
  if (are_balls_apart(a, b, &work)) return;
  const WideQuery query(a, b, work);
  if (query.are_far_apart(work)) return;
  bvh::WidePairWalk walk = query.walk(bvh::WidePairWalk::Goal::AllPairs);
  Candidates candidates(touch, work);
  query.decide_all(walk, candidates, on_pair);
  add_counts(walk.counts(), work);
}

bool has_wide_pair(const PlacedMeshView& a, const PlacedMeshView& b, Touch touch, Work& work) {
  const WideQuery query(a, b, work);
  if (query.are_far_apart(work)) return false;
  bvh::WidePairWalk walk = query.walk(bvh::WidePairWalk::Goal::AnyPair);
  Candidates candidates(touch, work);
  const bvh::Walk end =
      query.decide_any(walk, candidates, [](TrianglePair) { return bvh::Walk::Stop; });
  add_counts(walk.counts(), work);
  return end == bvh::Walk::Stop;
}

/// Calls `on_pair(pair)` with the indices of each pair of triangles that meet, until it answers
/// Stop.
template <typename OnPair>
void for_each_pair(const PlacedMeshView& a, const PlacedMeshView& b, const PairSettings& settings,
                   Work& work, OnPair&& on_pair) {
  narrowphase::check_touch(settings.touch);
  const std::optional<Volume> volume = binary_volume(settings.volume);
  if (!volume) return for_each_wide_pair(a, b, settings.touch, work, on_pair);
  const auto by_volume = [&](const bvh::RelativeFrame& frame, auto&& use) {
    with_separation(*volume, frame, volumes_of(a.mesh, *volume, work),
                    volumes_of(b.mesh, *volume, work), use);
  };
  for_each_binary_pair(a, b, settings.touch, work, by_volume, on_pair);
}

}  // namespace

// Public functions do their work in in_standard_arithmetic(): it sees to it that the CPU rounds as
// all error bounds take for granted, and calls what it is given.

bool intersects(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b, Work* work) {
  return intersects(mesh_a, mesh_b, QuerySettings{}, work);
}

bool intersects(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                const QuerySettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    check_hit(settings.hit);
    const bool is_solid = settings.hit == Hit::Solid;
    if (is_solid) {
      check_closed(mesh_a.mesh, "mesh A");
      check_closed(mesh_b.mesh, "mesh B");
    }
    // This comes before there are counters: to clear them takes as long as to see this.
    if (settings.volume == PairVolume::WideObb && are_balls_apart(mesh_a, mesh_b, work))
      return false;
    CountedWork counted(work);
    const bool is_touching =
        settings.volume == PairVolume::WideObb
            ? has_wide_pair(mesh_a, mesh_b, touch_of(settings.hit), counted.work())
            : has_any([&](auto&& on_pair) {
                for_each_pair(mesh_a, mesh_b,
                              {.volume = settings.volume, .touch = touch_of(settings.hit)},
                              counted.work(), on_pair);
              });
    return is_touching || (is_solid && is_either_inside(mesh_a, mesh_b, counted.work()));
  });
}

TrianglePairs find_triangle_pairs(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                                  const PairSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> TrianglePairs {
    CountedWork counted(work);
    TrianglePairs found;
    found.completeness = collect(found.pairs, settings.limit, [&](auto&& on_pair) {
      for_each_pair(mesh_a, mesh_b, settings, counted.work(), on_pair);
    });
    return found;
  });
}

template <typename>
TrianglePairs find_triangle_pairs(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                                  const SharedPairSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> TrianglePairs {
    CountedWork counted(work);
    check_threads(settings.threads);
    if (settings.threads == 1)
      return find_triangle_pairs(mesh_a, mesh_b, {.touch = settings.touch}, &counted.work());
    narrowphase::check_touch(settings.touch);
    TrianglePairs found;
    if (are_balls_apart(mesh_a, mesh_b, &counted.work())) return found;
    const WideQuery query(mesh_a, mesh_b, counted.work());
    if (!query.are_far_apart(counted.work())) {
      found.pairs = find_pairs_in_parallel(query, settings.touch, settings.threads, counted.work());
    }
    return found;
  });
}

template TrianglePairs find_triangle_pairs<void>(const PlacedMeshView&, const PlacedMeshView&,
                                                 const SharedPairSettings&, Work*);

void find_triangle_pairs_into(std::vector<TrianglePair>& pairs, const PlacedMeshView& mesh_a,
                              const PlacedMeshView& mesh_b, Work& work) {
  pairs.clear();
  for_each_wide_pair(mesh_a, mesh_b, Touch::Include, work, [&](const TrianglePair& pair) {
    pairs.push_back(pair);
    return bvh::Walk::Continue;
  });
  std::sort(pairs.begin(), pairs.end());
}

}  // namespace graze
