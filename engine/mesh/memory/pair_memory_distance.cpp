#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/memory/pair_cache.h>
#include <graze/engine/mesh/nearest/distance_limit.h>
#include <graze/engine/mesh/nearest/distance_parts.h>
#include <graze/engine/mesh/pair_memory.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/narrowphase/derived/directed_gap.h>

#include <algorithm>
#include <utility>

namespace graze {
namespace {

/// A query for pairs within a limit that comes down, which asks a front. It takes the limit and the
/// direction in which to look from a pair of triangles whose distance is known.
class NearQuery {
 public:
  NearQuery(const WideQuery& query, PairCache& cache, Work& work)
      : query_(query),
        box_limit_(query_.frame_a, query_.frame_b, query_.b_in_a),
        largest_(std::max(largest_of(query.a), largest_of(query.b))),
        gap_(largest_),
        cache_(cache),
        work_(work) {}

  /// Looks along the line between these points for gaps beyond so many metres.
  void aim_along(const TriangleDistance& found) { gap_.set_direction(found); }
  void shrink_to(double metres) {
    limit_ = metres;
    box_limit_.shrink_to(metres);
  }

  /// Calls `on_pair(pair, distance)` for each pair that may be within the limit, which may come
  /// down meanwhile, until it answers Stop. Returns false if there is no front that can answer:
  /// then it calls for none.
  template <typename OnPair>
  bool ask_front(OnPair&& on_pair) {
    MotionFront& near = cache_.distance_front;
    if (near.use_up_rest() || !cache_.add_motion(query_)) return false;
    auto pass = near.start_pass(query_.tree_a, query_.tree_b, query_.b_in_a, query_.a_in_b(),
                                box_limit_.units());
    if (!pass) return false;
    double direction_in_a[3];
    turn_into(direction_in_a, query_.a.pose, gap_.direction());
    pass->aim_along(direction_in_a);
    near.update(*pass, box_limit_.units(), work_);
    bvh::WideFront& front = near.front();
    for (std::size_t i = 0; i < front.near_pair_count(); ++i) {
      if (front.renew_budget(i, *pass, box_limit_.units())) continue;
      const TrianglePair pair = query_.pair_at(front.near_pair(i));
      const Triangle triangle_a = query_.triangle_a(pair);
      const Triangle triangle_b = query_.triangle_b(pair);
      const double end = gap_.end_of(triangle_a);
      const double start = gap_.start_of(triangle_b);
      if (gap_.is_beyond(limit_, end, start)) {
        front.keep_apart(i, *pass, gap_along(gap_, start - end, pass->slack));
        continue;
      }
      const TriangleDistance found = distance_of(triangle_a, triangle_b, work_);
      front.set_gap(i, *pass, units_between(found.distance));
      // A pair that is as near as any is asked again in the next pose, so no plane is kept for it.
      if (found.distance > limit_) {
        narrowphase::DirectedGap along(largest_);
        along.set_direction(found);
        front.keep_apart(
            i, *pass,
            gap_along(along, along.start_of(triangle_b) - along.end_of(triangle_a), pass->slack));
      }
      if (on_pair(pair, found) == bvh::Walk::Stop) return true;
    }
    cache_.learn_gap(box_limit_.least_metres(front.proven_gap(*pass) - 2 * query_.b_in_a.slack));
    return true;
  }

  /// Returns a lower bound of the true distance, from one as distance() returns it.
  double lower_bound_of(double metres) const { return metres - 0x1p-46 * largest_; }

 private:
  /// Turns a direction in space into the frame of a pose.
  static void turn_into(double (&turned)[3], const Pose& pose, const double (&direction)[3]) {
    const double* m = pose.data();  // column-major 4x4
    for (int i = 0; i < 3; ++i) {
      turned[i] =
          m[4 * i] * direction[0] + m[4 * i + 1] * direction[1] + m[4 * i + 2] * direction[2];
    }
  }

  /// Returns a lower bound, in the trees' frames, of a distance in space.
  double units_between(double metres) const {
    return box_limit_.least_units(lower_bound_of(metres)) - 2 * query_.b_in_a.slack;
  }

  /// Returns the same of a gap along a direction, with the slack of both frames.
  bvh::WideFront::Gap gap_along(const narrowphase::DirectedGap& along, double metres,
                                double slack) const {
    // A pose makes the direction that it turns longer by 1.5e-6 at most.
    constexpr double kShorter = 1 - 0x1p-18;
    bvh::WideFront::Gap gap;
    gap.units = kShorter * (box_limit_.least_units_along(lower_bound_of(metres)) - 2 * slack);
    turn_into(gap.along_in_a, query_.a.pose, along.direction());
    turn_into(gap.along_in_b, query_.b.pose, along.direction());
    for (int i = 0; i < 3; ++i)
      gap.along_in_a[i] *= kShorter, gap.along_in_b[i] *= kShorter;
    return gap;
  }

  const WideQuery& query_;
  DistanceLimit box_limit_;
  double largest_;
  narrowphase::DirectedGap gap_;
  double limit_ = 0;
  PairCache& cache_;
  Work& work_;
};

/// Takes note of where B is in A. Returns whether it moved so far there since distance() was last
/// asked that this is no motion but a step to another pose: what was nearest bounds little then,
/// and a front would have to open all that is nearer.
bool came_by_far_step(const PlacedMeshView& a, const PlacedMeshView& b, PairCache& cache) {
  const Eigen::Matrix3d back = a.pose.linear().transpose();
  Pose now = Pose::Identity();
  now.linear() = back * b.pose.linear();
  now.translation() = back * (b.pose.translation() - a.pose.translation());
  const std::optional<Pose> before = std::exchange(cache.nearest_pose, now);
  if (!before) return false;
  const auto width = [](const Aabb& box) { return (box.max - box.min).maxCoeff(); };
  const Aabb& box = b.mesh.bounds();
  const Eigen::Vector3d middle = box.min / 2 + box.max / 2;
  const double moved = (now * middle - *before * middle).norm() +
                       (now.linear() - before->linear()).norm() * width(box);
  constexpr double kShare = 0x1p-4;
  return moved > kShare * std::min(width(a.mesh.bounds()), width(box));
}

/// Returns the distance of the meshes, beginning with the pair that was nearest before.
MeshDistance find_nearest(const WideQuery& meshes, TrianglePair pair, PairCache& cache,
                          Work& work) {
  const TriangleDistance known = distance_of(meshes, pair, work);
  if (known.distance == 0) return find_distance(meshes, pair, work);
  NearQuery query(meshes, cache, work);
  MeshDistance best = result_of(known, pair);
  query.shrink_to(best.distance);
  query.aim_along(known);
  const bool is_done = query.ask_front([&](TrianglePair other, const TriangleDistance& found) {
    if (found.distance < best.distance) {
      best = result_of(found, other);
      query.shrink_to(best.distance);
    }
    if (found.distance == best.distance && other < best.pair) best = result_of(found, other);
    return best.distance == 0 ? bvh::Walk::Stop : bvh::Walk::Continue;
  });
  if (!is_done) {
    best = cache.are_apart_by(0) ? distance_apart(meshes, best.pair, work)
                                 : find_distance(meshes, best.pair, work);
  } else if (best.distance == 0) {
    best = find_distance(meshes, best.pair, work);  // it decides which touching pair is returned
  }
  if (best.distance > 0) cache.learn_gap(query.lower_bound_of(best.distance));
  return best;
}

}  // namespace

MeshDistance distance(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                      PairMemory& memory, const DistanceSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> MeshDistance {
    CountedWork counted(work);
    check_hint(settings, mesh_a.mesh, mesh_b.mesh);
    PairCache& cache = recall(memory, mesh_a, mesh_b);
    const WideQuery query(mesh_a, mesh_b, cache.deviation_a(), cache.deviation_b(), counted.work());
    const std::optional<TrianglePair> hint = cache.nearest ? cache.nearest : settings.hint;
    const bool is_far_step = came_by_far_step(mesh_a, mesh_b, cache);
    // After a touch another is likelier than a gap; a walk decides which touching pair is returned.
    const bool may_touch = !cache.nearest || cache.was_touching || is_far_step;
    MeshDistance best = may_touch ? find_distance(query, hint, counted.work())
                                  : find_nearest(query, *hint, cache, counted.work());
    cache.nearest = best.pair;
    cache.was_touching = best.distance == 0;
    return best;
  });
}

bool within(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b, double clearance,
            PairMemory& memory, const DistanceSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    check_clearance(clearance);
    check_hint(settings, mesh_a.mesh, mesh_b.mesh);
    PairCache& cache = recall(memory, mesh_a, mesh_b);
    if (cache.are_still_apart_by(clearance, work)) return false;
    CountedWork counted(work);
    const WideQuery meshes(mesh_a, mesh_b, cache.deviation_a(), cache.deviation_b(),
                           counted.work());
    std::optional<TriangleDistance> known;
    if (cache.nearest) {
      known = distance_of(meshes, *cache.nearest, counted.work());
      if (known->distance <= clearance) {
        ++cache.still_touching;
        ++counted.work().skipped_by_memory;
        return true;
      }
    }
    NearQuery query(meshes, cache, counted.work());
    query.shrink_to(clearance);
    if (known) query.aim_along(*known);
    std::optional<TrianglePair> found;
    const auto on_pair = [&](TrianglePair pair, const TriangleDistance& between) {
      if (between.distance <= clearance) found = pair;
      return found ? bvh::Walk::Stop : bvh::Walk::Continue;
    };
    // After a hit another is likelier than a gap.
    const bool was_within = cache.was_within;
    if (was_within || !query.ask_front(on_pair)) {
      found = find_within(meshes, clearance, settings.hint, counted.work());
    }
    if (found) cache.nearest = found;
    cache.was_within = found.has_value();
    return found.has_value();
  });
}

}  // namespace graze
