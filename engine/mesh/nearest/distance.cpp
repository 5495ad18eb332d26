#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/number_text.h>
#include <graze/bvh/wide/walk/wide_distance_walk.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/nearest/distance_limit.h>
#include <graze/engine/mesh/nearest/distance_parts.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/placing/relative_frame.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/query/wide_query.h>
#include <graze/narrowphase/derived/directed_gap.h>
#include <graze/narrowphase/derived/distance_stages.h>
#include <graze/narrowphase/derived/nearest_vertices.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace graze {
namespace {

// The share of the best distance so far within which a walk looks first: only where much could be
// gained, and so it has a limit that is not far above the answer for the rest. As measured, it
// saves up to half of the time.
constexpr double kFirstShare = 0.5;

/// Walks pairs of triangles, nearer ones first, and leaves out what is beyond a limit.
class Search {
 public:
  Search(const WideQuery& query, Work& work)
      : query_(query),
        a_in_b_(query.a_in_b()),
        box_limit_(query.frame_a, query.frame_b, query.b_in_a),
        gap_(std::max(largest_of(query.a), largest_of(query.b))),
        work_(work) {}

  /// Begins with what is within this share of the limit.
  void look_first_within(double share) { first_share_ = share; }

  void shrink_to(double metres) {
    limit_ = metres;
    box_limit_.shrink_to(metres);
  }

  /// Looks first along the line between the nearest points found so far.
  void aim_along(const TriangleDistance& found) {
    gap_.set_direction(found);
    vertices_.set(found);
    const double(&z)[3] = gap_.direction();
    const bvh::LocalFrame& frame = query_.tree_a.frame();
    const double* o = frame.centre;
    const double per_metre = query_.b_in_a.units_a / frame.unit();
    const double* m = query_.a.pose.data();  // column-major 4x4
    double offset[3];                        // the offset from where the frame's centre is placed
    for (int i = 0; i < 3; ++i) {
      offset[i] = found.point_a[i] - (m[i] * o[0] + m[4 + i] * o[1] + m[8 + i] * o[2] + m[12 + i]);
    }
    for (int i = 0; i < 3; ++i) {
      const double* axis = m + 4 * i;
      direction_in_a_[i] = axis[0] * z[0] + axis[1] * z[1] + axis[2] * z[2];
      point_in_a_[i] =
          (axis[0] * offset[0] + axis[1] * offset[1] + axis[2] * offset[2]) * per_metre;
    }
  }

  /// Calls `on_pair(pair, distance)` for each pair that may be within the limit, until it answers
  /// Stop.
  template <typename OnPair>
  void run(OnPair&& on_pair) {
    bvh::WideDistanceWalk walk(query_.tree_a, query_.tree_b, query_.b_in_a, a_in_b_,
                               box_limit_.margins());
    if (first_share_ < 1) walk.look_first_within(first_share_);
    bvh::BoundedPlaces found[bvh::WideDistanceWalk::kMostAtOnce];
    bool is_stopped = false;
    while (!is_stopped) {
      walk.aim_along(direction_in_a_, point_in_a_);
      const std::size_t count = walk.next(found, box_limit_.square());
      if (count == 0) break;
      std::sort(found, found + count, [](const auto& one, const auto& other) {
        return one.squared_bound < other.squared_bound;
      });
      for (std::size_t i = 0; i < count && !is_stopped; ++i) {
        if (walk.is_beyond(found[i], box_limit_.square())) break;
        is_stopped = visit(found[i].places, on_pair) == bvh::Walk::Stop;
      }
    }
    add_counts(walk.counts(), work_);
  }

 private:
  template <typename OnPair>
  bvh::Walk visit(bvh::PlacePair places, OnPair&& on_pair) {
    const TrianglePair pair = query_.pair_at(places);
    const Triangle triangle_a = query_.triangle_a(pair);
    const Triangle triangle_b = query_.triangle_b(pair);
    if (gap_.is_beyond(limit_, gap_.end_of(triangle_a), gap_.start_of(triangle_b)))
      return bvh::Walk::Continue;
    if (const TriangleDistance* known = vertices_.of(triangle_a, triangle_b))
      return on_pair(pair, *known);
    return on_pair(pair, distance_of(triangle_a, triangle_b, work_));
  }

  const WideQuery& query_;
  bvh::RelativeFrame a_in_b_;
  DistanceLimit box_limit_;
  narrowphase::DirectedGap gap_;
  narrowphase::NearestVertices vertices_;
  double direction_in_a_[3] = {0, 0, 0};
  double point_in_a_[3] = {0, 0, 0};  ///< a point near the nearest found so far, in common units
  double limit_ = std::numeric_limits<double>::infinity();
  double first_share_ = 1;
  Work& work_;
};

/// What a walk to all pairs of triangles that meet says of the first of them.
struct Meeting {
  /// The pair that a query for pairs with a limit of 1 begins with, if any meet: which this is
  /// depends on no direction, hint, memory or kernel.
  std::optional<TrianglePair> met;
  /// If none meet, the last pair that boxes and planes did not part, if there was one: good to
  /// begin a search with.
  std::optional<TrianglePair> near;
};

Meeting find_meeting(const WideQuery& query, Work& work) {
  Meeting meeting;
  if (query.are_far_apart(work)) return meeting;
  bvh::WidePairWalk walk = query.walk(bvh::WidePairWalk::Goal::AllPairs);
  Candidates candidates(Touch::Include, work);
  query.decide_first_in_order(walk, candidates, [&](TrianglePair pair) {
    meeting.met = pair;
    return bvh::Walk::Stop;
  });
  add_counts(walk.counts(), work);
  if (walk.last_near()) meeting.near = query.pair_at(*walk.last_near());
  return meeting;
}

/// Searches for the distance of meshes that are apart: begins with a pair, then with what is within
/// a share of how far apart these are.
MeshDistance search(const WideQuery& query, TrianglePair first, double first_share, Work& work) {
  Search search(query, work);
  MeshDistance best{};
  const auto improve_to = [&](TrianglePair pair, const TriangleDistance& found) {
    best = result_of(found, pair);
    search.shrink_to(best.distance);
    search.aim_along(found);
  };
  improve_to(first, distance_of(query, first, work));
  search.look_first_within(first_share);
  search.run([&](TrianglePair pair, const TriangleDistance& found) {
    if (found.distance < best.distance) improve_to(pair, found);
    if (found.distance == best.distance && pair < best.pair) best = result_of(found, pair);
    return bvh::Walk::Continue;
  });
  return best;
}

}  // namespace

void check_hint(const DistanceSettings& settings, const Mesh& a, const Mesh& b) {
  if (!settings.hint) return;
  const auto check = [](std::uint32_t index, std::size_t count, const char* name) {
    if (index < count) return;
    throw InputError(std::string("hint: triangle ") + std::to_string(index) + " of mesh " + name +
                         ", which has " + std::to_string(count),
                     {.element = "triangle", .index = index});
  };
  check(settings.hint->a, a.triangles().size(), "A");
  check(settings.hint->b, b.triangles().size(), "B");
}

void check_clearance(double clearance) {
  if (clearance >= 0) return;
  throw InputError("clearance: " + bvh::number_text(clearance) + " is not a distance");
}

double largest_of(const PlacedMeshView& placed) {
  const std::array<double, 3> largest = largest_coordinates(placed.pose, placed.mesh.bounds());
  return std::max(largest[0], std::max(largest[1], largest[2]));
}

TriangleDistance distance_of(const Triangle& triangle_a, const Triangle& triangle_b, Work& work) {
  const narrowphase::StagedDistance found = narrowphase::decide_distance(triangle_a, triangle_b);
  ++work.triangle_tests;
  work.exact_tests += found.stage == narrowphase::Stage::Exact;
  return found.result;
}

TriangleDistance distance_of(const WideQuery& query, TrianglePair pair, Work& work) {
  return distance_of(query.triangle_a(pair), query.triangle_b(pair), work);
}

MeshDistance result_of(const TriangleDistance& found, TrianglePair pair) {
  return {found.distance, found.point_a, found.point_b, pair};
}

MeshDistance distance_apart(const WideQuery& query, TrianglePair hint, Work& work) {
  return search(query, hint, 1, work);
}

MeshDistance find_distance(const WideQuery& query, std::optional<TrianglePair> hint, Work& work) {
  // This was measured: where the meshes are apart it takes a twentieth of what follows, and where
  // they meet the search for what is nearest would take five times longer to see it.
  const Meeting meeting = find_meeting(query, work);
  if (meeting.met) return result_of(distance_of(query, *meeting.met, work), *meeting.met);
  if (hint) return distance_apart(query, *hint, work);
  return search(query, meeting.near.value_or(TrianglePair{0, 0}), kFirstShare, work);
}

MeshDistance distance(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                      const DistanceSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> MeshDistance {
    CountedWork counted(work);
    check_hint(settings, mesh_a.mesh, mesh_b.mesh);
    return find_distance(WideQuery(mesh_a, mesh_b, counted.work()), settings.hint, counted.work());
  });
}

std::optional<TrianglePair> find_within(const WideQuery& query, double clearance,
                                        std::optional<TrianglePair> hint, Work& work) {
  Search search(query, work);
  search.shrink_to(clearance);
  if (hint) {
    const TriangleDistance known = distance_of(query, *hint, work);
    if (known.distance <= clearance) return hint;
    search.aim_along(known);
  }
  std::optional<TrianglePair> found_pair;
  double nearest = std::numeric_limits<double>::infinity();
  search.run([&](TrianglePair pair, const TriangleDistance& found) {
    if (found.distance <= clearance) found_pair = pair;
    if (found.distance < nearest) {
      nearest = found.distance;
      search.aim_along(found);
    }
    return found_pair ? bvh::Walk::Stop : bvh::Walk::Continue;
  });
  return found_pair;
}

bool within(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b, double clearance,
            const DistanceSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    check_clearance(clearance);
    CountedWork counted(work);
    check_hint(settings, mesh_a.mesh, mesh_b.mesh);
    const WideQuery query(mesh_a, mesh_b, counted.work());
    return find_within(query, clearance, settings.hint, counted.work()).has_value();
  });
}

}  // namespace graze
