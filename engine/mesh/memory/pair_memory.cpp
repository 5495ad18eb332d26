#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/inside/solid.h>
#include <graze/engine/mesh/memory/pair_cache.h>
#include <graze/engine/mesh/pair_memory.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/query/sort_pairs.h>
#include <graze/engine/mesh/query/threads.h>
#include <graze/engine/mesh/query/wide_query.h>
#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/triangle_pair/crossing_stages.h>
#include <hwy/base.h>

#include <algorithm>

namespace graze {

PairMemory::PairMemory() = default;
PairMemory::PairMemory(PairMemory&& other) noexcept = default;
PairMemory& PairMemory::operator=(PairMemory&& other) noexcept = default;
PairMemory::~PairMemory() = default;

PairMemory::PairMemory(const PairMemory& other)
    : cache_(other.cache_ ? std::make_unique<PairCache>(*other.cache_) : nullptr) {}

PairMemory& PairMemory::operator=(const PairMemory& other) {
  PairMemory copy(other);
  cache_ = std::move(copy.cache_);
  return *this;
}

std::uint64_t PairMemory::still_apart() const {
  return cache_ ? cache_->still_apart : 0;
}

std::uint64_t PairMemory::still_touching() const {
  return cache_ ? cache_->still_touching : 0;
}

namespace {

/// A query of two meshes of which it is not known that they are apart.
class IntersectionQuery {
 public:
  IntersectionQuery(const PlacedMeshView& a, const PlacedMeshView& b, PairCache& cache, Touch touch,
                    Work& work)
      : query_(a, b, cache.deviation_a(), cache.deviation_b(), work),
        cache_(cache),
        touch_(touch),
        work_(work) {}

  /// True if the boxes around both meshes prove that they are apart: then the cache keeps the gap.
  /// They are not asked while a front is in use, which holds these boxes, too.
  bool are_boxes_apart() {
    if (cache_.intersection_front.is_in_use()) return false;
    if (!query_.are_far_apart(work_)) return false;
    cache_.learn_gap(gap_of_bounds(query_));
    return true;
  }

  /// True if any of the pairs that touched when last asked, of which the cache keeps up to eight,
  /// still does.
  bool does_any_cached_pair_touch() {
    const std::span<const TrianglePair> pairs = cache_.pairs();
    if (pairs.empty()) return false;
    Candidates candidates(touch_, work_);
    std::size_t touching = pairs.size();
    const auto on_pair = [&](TrianglePair pair) {
      touching =
          static_cast<std::size_t>(std::find(pairs.begin(), pairs.end(), pair) - pairs.begin());
      return bvh::Walk::Stop;
    };
    for (std::size_t i = 0; i < pairs.size() && touching == pairs.size(); ++i) {
      candidates.add(pairs[i], query_.triangle_a(pairs[i]), query_.triangle_b(pairs[i]));
      // The first pair is decided alone: most of the time it is enough.
      if (i == 0 || i + 1 == pairs.size()) candidates.decide(on_pair);
    }
    if (touching == pairs.size()) return false;
    cache_.put_first(touching);
    ++cache_.still_touching;
    ++work_.skipped_by_memory;
    return true;
  }

  /// Calls `on_pair(pair)` for each pair that meets, until it answers Stop. Returns false if there
  /// is no front that can answer: then it calls for none.
  template <typename OnPair>
  bool ask_front(OnPair&& on_pair) {
    if (cache_.intersection_front.use_up_rest() || !cache_.add_motion(query_)) return false;
    const bvh::RelativeFrame a_in_b = query_.a_in_b();
    const auto pass = cache_.intersection_front.start_pass(query_.tree_a, query_.tree_b,
                                                           query_.b_in_a, a_in_b, 0);
    if (!pass) return false;
    cache_.intersection_front.update(*pass, 0, work_);
    const bvh::WideFront& front = cache_.intersection_front.front();
    for (std::size_t i = 0; i < front.crossing_count(); ++i) {
      if (on_pair(query_.pair_at(front.crossing(i))) == bvh::Walk::Stop) return true;
    }
    bool is_any_met = front.crossing_count() > 0;
    const auto on_met = [&](TrianglePair pair) {
      is_any_met = true;
      return on_pair(pair);
    };
    if (front.unsure_count() > 0 && decide_left_open(front, on_met) == bvh::Walk::Stop) return true;
    if (!is_any_met) {
      const double unit = std::max(query_.frame_a.frame.unit(), query_.frame_b.frame.unit());
      cache_.learn_gap(front.proven_gap(*pass) * unit * (1 - 1e-5));
    }
    return true;
  }

  /// Does the same by walking the trees.
  template <typename OnPair>
  void walk(OnPair&& on_pair) {
    Work done;
    bvh::WidePairWalk walk = query_.walk(bvh::WidePairWalk::Goal::AnyPair);
    Candidates candidates(touch_, done);
    const bvh::Walk end = query_.decide_any(walk, candidates, on_pair);
    add_counts(walk.counts(), done);
    if (end == bvh::Walk::Continue) cache_.intersection_front.learn_walk(done);
    work_ += done;
  }

 private:
  template <typename OnPair>
  bvh::Walk decide_left_open(const bvh::WideFront& front, OnPair&& on_pair) {
    Candidates candidates(touch_, work_);
    for (std::size_t i = 0; i < front.unsure_count(); ++i) {
      const TrianglePair pair = query_.pair_at(front.unsure(i));
      candidates.add(pair, query_.triangle_a(pair), query_.triangle_b(pair));
      if (candidates.is_full() && candidates.decide(on_pair) == bvh::Walk::Stop)
        return bvh::Walk::Stop;
    }
    return candidates.decide(on_pair);
  }

  WideQuery query_;
  PairCache& cache_;
  Touch touch_;
  Work& work_;
};

// The functions that follow are not inlined: a query that a known gap answers should not pay for
// their frames and counters.

HWY_NOINLINE bool do_surfaces_meet(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                                   PairCache& cache, Touch touch, Work* work) {
  CountedWork counted(work);
  IntersectionQuery query(mesh_a, mesh_b, cache, touch, counted.work());
  if (query.are_boxes_apart()) return false;
  if (query.does_any_cached_pair_touch()) return true;
  // After a hit another is likelier than a gap.
  const bool was_apart = cache.pairs().empty();
  TrianglePair found[PairCache::kMostPairs];
  std::size_t count = 0;
  const auto on_pair = [&](TrianglePair pair) {
    found[count++] = pair;
    return bvh::Walk::Stop;
  };
  if (!was_apart || !query.ask_front(on_pair)) query.walk(on_pair);
  cache.remember({found, count});
  return count > 0;
}

HWY_NOINLINE bool is_one_inside(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                                Work* work) {
  CountedWork counted(work);
  return is_either_inside(mesh_a, mesh_b, counted.work());
}

/// Keeps what a query found. The next pose has about as many pairs: it reserves room for a quarter
/// more.
void remember(const TrianglePairs& found, PairCache& cache) {
  cache.remember(found.pairs);
  cache.pairs_found = found.pairs.size() + found.pairs.size() / 4;
}

HWY_NOINLINE TrianglePairs find_meeting_pairs(const PlacedMeshView& mesh_a,
                                              const PlacedMeshView& mesh_b, PairCache& cache,
                                              const MemoryPairSettings& settings, Work* work) {
  CountedWork counted(work);
  TrianglePairs found;
  IntersectionQuery query(mesh_a, mesh_b, cache, settings.touch, counted.work());
  if (query.are_boxes_apart()) return found;
  const bool is_done = query.ask_front([&](TrianglePair pair) {
    if (found.pairs.empty()) found.pairs.reserve(std::min(cache.pairs_found, settings.limit));
    found.pairs.push_back(pair);
    return found.pairs.size() > settings.limit ? bvh::Walk::Stop : bvh::Walk::Continue;
  });
  if (is_done && found.pairs.size() <= settings.limit) {
    sort_pairs(found.pairs);
  } else {
    // With a limit, the walk decides which pairs are returned.
    Work done;
    found = find_triangle_pairs(mesh_a, mesh_b, {.limit = settings.limit, .touch = settings.touch},
                                &done);
    if (found.completeness == Completeness::Complete) cache.intersection_front.learn_walk(done);
    counted.work() += done;
  }
  remember(found, cache);
  return found;
}

HWY_NOINLINE TrianglePairs find_shared_pairs(const PlacedMeshView& mesh_a,
                                             const PlacedMeshView& mesh_b, PairCache& cache,
                                             const SharedPairSettings& settings, Work* work) {
  CountedWork counted(work);
  if (IntersectionQuery(mesh_a, mesh_b, cache, settings.touch, counted.work()).are_boxes_apart())
    return {};
  TrianglePairs found = find_triangle_pairs(mesh_a, mesh_b, settings, &counted.work());
  remember(found, cache);
  return found;
}

}  // namespace

// Public functions do their work in in_standard_arithmetic(): it sees to it that the CPU rounds as
// all error bounds take for granted, and calls what it is given.

bool intersects(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b, PairMemory& memory,
                const MemoryQuerySettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    check_hit(settings.hit);
    if (settings.hit == Hit::Solid) {
      check_closed(mesh_a.mesh, "mesh A");
      check_closed(mesh_b.mesh, "mesh B");
    }
    PairCache& cache = recall(memory, mesh_a, mesh_b);
    if (!cache.are_still_apart_by(0, work) &&
        do_surfaces_meet(mesh_a, mesh_b, cache, touch_of(settings.hit), work))
      return true;
    return settings.hit == Hit::Solid && is_one_inside(mesh_a, mesh_b, work);
  });
}

TrianglePairs find_triangle_pairs(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                                  PairMemory& memory, const MemoryPairSettings& settings,
                                  Work* work) {
  return bvh::in_standard_arithmetic([&]() -> TrianglePairs {
    narrowphase::check_touch(settings.touch);
    PairCache& cache = recall(memory, mesh_a, mesh_b);
    if (cache.are_still_apart_by(0, work)) return {};
    return find_meeting_pairs(mesh_a, mesh_b, cache, settings, work);
  });
}

template <typename>
TrianglePairs find_triangle_pairs(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                                  PairMemory& memory, const SharedPairSettings& settings,
                                  Work* work) {
  return bvh::in_standard_arithmetic([&]() -> TrianglePairs {
    narrowphase::check_touch(settings.touch);
    check_threads(settings.threads);
    PairCache& cache = recall(memory, mesh_a, mesh_b);
    if (cache.are_still_apart_by(0, work)) return {};
    if (settings.threads == 1)
      return find_meeting_pairs(mesh_a, mesh_b, cache, {.touch = settings.touch}, work);
    return find_shared_pairs(mesh_a, mesh_b, cache, settings, work);
  });
}

template TrianglePairs find_triangle_pairs<void>(const PlacedMeshView&, const PlacedMeshView&,
                                                 PairMemory&, const SharedPairSettings&, Work*);

}  // namespace graze
