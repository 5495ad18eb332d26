#include <graze/bvh/error.h>
#include <graze/engine/mesh/distance_parts.h>
#include <graze/engine/mesh/distance_reach.h>
#include <graze/engine/mesh/pair_memory.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query_results.h>
#include <graze/engine/mesh/remembered.h>
#include <graze/narrowphase/derived/directed_gap.h>
#include <graze/narrowphase/derived/distance_stages.h>

#include <algorithm>

namespace graze {
namespace {

TriangleDistance decided(const Triangle& triangle_a, const Triangle& triangle_b, Work& work) {
  const narrowphase::StagedDistance found = narrowphase::decide_distance(triangle_a, triangle_b);
  ++work.triangle_tests;
  work.exact_tests += found.stage == narrowphase::Stage::Exact;
  return found.result;
}

TriangleDistance distance_of(const PlacedMesh& a, const PlacedMesh& b, TrianglePair pair,
                             Work& work) {
  return decided(place(a.pose, a.mesh.triangle(pair.a)), place(b.pose, b.mesh.triangle(pair.b)),
                 work);
}

/// A query that knows a pair of triangles near each other.
class NearQuery {
 public:
  NearQuery(const PlacedMesh& a, const PlacedMesh& b, Remembered& remembered, Work& work)
      : query_(a, b, remembered.deviation_a(), remembered.deviation_b(), work),
        reach_(query_.frame_a, query_.frame_b, query_.b_in_a),
        largest_(std::max(largest_of(a), largest_of(b))),
        gap_(largest_),
        remembered_(remembered),
        work_(work) {}

  /// Looks for what separates along the way between these points, beyond so many metres.
  void aim_along(const TriangleDistance& found) { gap_.set_direction(found); }
  void shrink_to(double metres) {
    limit_ = metres;
    reach_.shrink_to(metres);
  }

  /// Calls `on_pair(pair, distance)` for each pair that may be within the limit, which may come
  /// down meanwhile, until it answers Stop. Whether the front could say: otherwise it calls for
  /// none.
  template <typename OnPair>
  bool pass_front(OnPair&& on_pair) {
    if (!remembered_.follow(query_)) return false;
    MotionFront& near = remembered_.near;
    auto pass = near.pass(query_.tree_a, query_.tree_b, query_.b_in_a,
                          relative_frame(query_.frame_b, query_.frame_a), reach_.units());
    if (!pass) return false;
    const double(&z)[3] = gap_.direction();
    const double* m = query_.a.pose.data();  // column-major 4x4
    double direction_in_a[3];
    for (int i = 0; i < 3; ++i)
      direction_in_a[i] = m[4 * i] * z[0] + m[4 * i + 1] * z[1] + m[4 * i + 2] * z[2];
    pass->aim_along(direction_in_a);
    near.advance(*pass, reach_.units(), work_);
    bvh::WideFront& front = near.front();
    for (std::size_t i = 0; i < front.candidate_count(); ++i) {
      if (!front.is_due(i, *pass, reach_.units())) continue;
      const TrianglePair pair = query_.pair_at(front.candidate(i).places);
      const Triangle triangle_a = query_.triangle_a(pair);
      const Triangle triangle_b = query_.triangle_b(pair);
      const double end = gap_.end_of(triangle_a);
      const double start = gap_.start_of(triangle_b);
      if (gap_.is_beyond(limit_, end, start)) {
        front.set_gap(i, *pass, units_between(start - end));
        continue;
      }
      const TriangleDistance found = decided(triangle_a, triangle_b, work_);
      front.set_gap(i, *pass, units_between(found.distance));
      if (on_pair(pair, found) == bvh::Walk::Stop) return true;
    }
    remembered_.learn_gap(reach_.least_metres(front.proven_gap(*pass) - 2 * query_.b_in_a.slack));
    return true;
  }

  /// What of a distance as it is returned is sure, and so of the true one.
  double surely(double metres) const { return metres - 0x1p-46 * largest_; }

 private:
  /// How far apart in the trees' frames what is so far apart in space is at least.
  double units_between(double metres) const {
    return reach_.least_units(surely(metres)) - 2 * query_.b_in_a.slack;
  }

  WideQuery query_;
  DistanceReach reach_;
  double largest_;
  narrowphase::DirectedGap gap_;
  double limit_ = 0;
  Remembered& remembered_;
  Work& work_;
};

/// What is nearest, or that something touches; `known` of the remembered pair.
MeshDistance find_nearest(const PlacedMesh& a, const PlacedMesh& b, const TriangleDistance& known,
                          Remembered& remembered, Work& work) {
  NearQuery query(a, b, remembered, work);
  MeshDistance best = result_of(known, *remembered.nearest);
  query.shrink_to(best.distance);
  query.aim_along(known);
  const bool is_done = query.pass_front([&](TrianglePair pair, const TriangleDistance& found) {
    if (found.distance < best.distance) {
      best = result_of(found, pair);
      query.shrink_to(best.distance);
    }
    if (found.distance == best.distance && pair < best.pair) best = result_of(found, pair);
    return best.distance == 0 ? bvh::Walk::Stop : bvh::Walk::Continue;
  });
  if (!is_done) {
    best = distance(a, b, DistanceSettings{.hint = best.pair}, &work);
  }
  if (best.distance > 0) remembered.learn_gap(query.surely(best.distance));
  return best;
}

}  // namespace

MeshDistance distance(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b, PairMemory& memory,
                      const DistanceSettings& settings, Work* work) {
  CountedWork counted(work);
  check_hint(settings, mesh_a.mesh, mesh_b.mesh);
  Remembered& remembered = recall(memory, mesh_a, mesh_b);
  MeshDistance best;
  if (!remembered.nearest) {
    best = distance(mesh_a, mesh_b, settings, &counted.work());
  } else {
    const TriangleDistance known = distance_of(mesh_a, mesh_b, *remembered.nearest, counted.work());
    best = result_of(known, *remembered.nearest);
    if (best.distance > 0) best = find_nearest(mesh_a, mesh_b, known, remembered, counted.work());
    if (best.distance == 0) {
      best.pair = first_pair_that_meets(mesh_a, mesh_b, counted.work());
      best = result_of(distance_of(mesh_a, mesh_b, best.pair, counted.work()), best.pair);
    }
  }
  remembered.nearest = best.pair;
  return best;
}

bool within(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b, double clearance,
            PairMemory& memory, const DistanceSettings& settings, Work* work) {
  check_clearance(clearance);
  CountedWork counted(work);
  check_hint(settings, mesh_a.mesh, mesh_b.mesh);
  Remembered& remembered = recall(memory, mesh_a, mesh_b);
  if (remembered.are_beyond(clearance)) {
    ++remembered.still_apart;
    ++counted.work().skipped_by_memory;
    return false;
  }
  std::optional<TriangleDistance> known;
  if (remembered.nearest) {
    known = distance_of(mesh_a, mesh_b, *remembered.nearest, counted.work());
    if (known->distance <= clearance) {
      ++remembered.still_touching;
      ++counted.work().skipped_by_memory;
      return true;
    }
  }
  NearQuery query(mesh_a, mesh_b, remembered, counted.work());
  query.shrink_to(clearance);
  if (known) query.aim_along(*known);
  std::optional<TrianglePair> found;
  const auto on_pair = [&](TrianglePair pair, const TriangleDistance& between) {
    if (between.distance <= clearance) found = pair;
    return found ? bvh::Walk::Stop : bvh::Walk::Continue;
  };
  // After a hit another is likelier than a gap.
  const bool was_within = remembered.was_within;
  if (was_within || !query.pass_front(on_pair)) {
    found = find_within(mesh_a, mesh_b, clearance, settings.hint, counted.work());
  }
  if (found) remembered.nearest = found;
  remembered.was_within = found.has_value();
  return found.has_value();
}

}  // namespace graze
