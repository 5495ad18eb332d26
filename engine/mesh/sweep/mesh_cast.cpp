#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/wide/walk/wide_cast_walk.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query/candidates.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/query/wide_query.h>
#include <graze/engine/mesh/sweep/cast_planes.h>
#include <graze/engine/mesh/sweep/earliest_meeting.h>
#include <graze/engine/mesh/sweep/sweep_line.h>
#include <graze/narrowphase/motion/path_checks.h>
#include <graze/narrowphase/translation/displacement.h>
#include <graze/narrowphase/triangle_intersection.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {
namespace {

/// Finds what meets before anything moves.
void ask_start(const WideQuery& query, EarliestMeeting& earliest, Work& work) {
  if (query.are_far_apart(work)) return;
  bvh::WidePairWalk walk = query.walk(bvh::WidePairWalk::Goal::AllPairs);
  Candidates candidates(Touch::Include, work);
  query.decide_all(walk, candidates, [&](TrianglePair pair) {
    earliest.ask_at_start(pair, query.triangle_a(pair), query.triangle_b(pair));
    return bvh::Walk::Continue;
  });
  add_counts(walk.counts(), work);
}

/// Finds what meets later, of what is apart at t = 0; where a policy leaves contacts out, some of
/// it may not be apart. What is found bounds what is still looked at; all pairs that may meet as
/// soon are looked at, as times decide exactly and then indices.
class CastWalk {
 public:
  CastWalk(const WideQuery& query, const contacts::SweepUnits& units, const SweepLine& line,
           StartContact start, EarliestMeeting& earliest, Work& work)
      : query_(query),
        may_touch_(start == StartContact::IsLeft),
        line_(line),
        earliest_(earliest),
        work_(work),
        limit_(line.at(earliest.limit())),
        planes_({{query.a}, units}, {{query.b}, units}, units, line.direction) {
    const Eigen::Vector3d direction = Eigen::Map<const Eigen::Vector3d>(line.direction);
    const double common = std::max(query.tree_a.frame().unit(), query.tree_b.frame().unit());
    per_unit_ = direction.norm() * (units.metres / common);
    set_in_a(direction, direction_);
  }

  void run() {
    bvh::WideCastWalk walk(query_.tree_a, query_.tree_b, query_.b_in_a, direction_);
    bvh::CastPlaces found[bvh::WideCastWalk::kMostAtOnce];
    while (const std::size_t count = walk.next(found, walk_limit())) {
      std::sort(found, found + count,
                [](const auto& one, const auto& other) { return one.bound < other.bound; });
      bool is_sooner = false;
      for (std::size_t i = 0; i < count && !(found[i].bound > walk_limit()); ++i)
        is_sooner |= ask(found[i]);
      if (is_sooner) turn(walk);
    }
    add_counts(walk.counts(), work_);
  }

 private:
  using Side = contacts::CastPlanes::Side;
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  static constexpr std::uint32_t kNone = 0xffffffffu;
  static constexpr std::uint32_t kKept = 32;

  /// Returns the limit with which the walk's bounds are compared: where no double can say it, all
  /// is near.
  double walk_limit() const {
    const double limit = limit_ * per_unit_;
    return limit >= 0 ? limit : kNever;
  }

  /// Takes a direction into the frame of A's tree, with length 1.
  void set_in_a(const Eigen::Vector3d& direction, double (&in_a)[3]) const {
    const Eigen::Vector3d turned = (query_.a.pose.linear().transpose() * direction).normalized();
    std::copy_n(turned.data(), 3, in_a);
  }

  /// A triangle that was placed, and its plane if that has been asked for: a walk comes back to the
  /// same few.
  struct Kept {
    std::uint32_t index = kNone;
    bool has_plane = false;
    Triangle triangle;
    contacts::CastPlanes::Plane plane;
  };

  static Kept& kept(Kept (&all)[kKept], const PlacedTriangles& triangles, std::uint32_t index) {
    Kept& kept = all[index % kKept];
    if (kept.index != index) {
      kept.index = index;
      kept.has_plane = false;
      kept.triangle = triangles[index];
    }
    return kept;
  }

  /// Asks two triangles. Returns true if they are the earliest so far.
  bool ask(const bvh::CastPlaces& places) {
    const TrianglePair pair = query_.pair_at(places.places);
    Kept& a = kept(kept_a_, query_.triangles_a, pair.a);
    Kept& b = kept(kept_b_, query_.triangles_b, pair.b);
    if (is_late(Side::A, a, b.triangle) || is_late(Side::B, b, a.triangle)) return false;
    ++work_.triangle_tests;
    if (may_touch_ && places.bound <= 0 && do_meet(a.triangle, b.triangle)) return false;
    if (!earliest_.ask_later(pair, a.triangle, b.triangle)) return false;
    limit_ = line_.at(earliest_.limit());
    return true;
  }

  /// True if the other triangle meets the plane later than the limit, or never: that bounds their
  /// meeting more closely than boxes do where surfaces face each other.
  bool is_late(Side side, Kept& own, const Triangle& other) const {
    if (!own.has_plane) own.plane = planes_.plane_of(side, own.triangle);
    own.has_plane = true;
    return planes_.first_contact(side, own.plane, other, limit_) == kNever;
  }

  void turn(bvh::WideCastWalk& walk) const {
    double normal[3];
    earliest_.rough_normal(normal);
    const Eigen::Vector3d rough = Eigen::Map<const Eigen::Vector3d>(normal);
    if (!(rough.squaredNorm() > 0x1p-400)) return;
    double in_a[3];
    set_in_a(rough.normalized(), in_a);
    walk.take_normal(in_a);
  }

  bool do_meet(const Triangle& a, const Triangle& b) {
    const narrowphase::Decision decision = narrowphase::decide(a, b);
    work_.exact_tests += decision.stage == narrowphase::Stage::Exact;
    return decision.is_hit;
  }

  const WideQuery& query_;
  bool may_touch_;
  const SweepLine& line_;
  EarliestMeeting& earliest_;
  Work& work_;
  double limit_;
  contacts::CastPlanes planes_;
  Kept kept_a_[kKept];
  Kept kept_b_[kKept];
  double direction_[3];  ///< the direction in the frame of A's tree
  double per_unit_;      ///< how far B goes in the trees' common units per unit of the sweep
};

}  // namespace

std::optional<MeshCast> cast(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                             const Eigen::Vector3d& displacement, const CastSettings& settings,
                             Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<MeshCast> {
    CountedWork counted(work);
    narrowphase::check_settings(settings);
    const WideQuery query(mesh_a, mesh_b, counted.work());
    narrowphase::check_displacement(displacement);
    const contacts::SweepUnits units(mesh_a, mesh_b);
    const SweepLine line(displacement, units);
    EarliestMeeting earliest(displacement.data(), settings.start);
    ask_start(query, earliest, counted.work());
    if (!earliest.is_at_start() && line.is_any())
      CastWalk(query, units, line, settings.start, earliest, counted.work()).run();
    std::optional<MeshCast> met = earliest.result();
    if (met && met->is_at_start) {
      met->point = intersection(query.triangle_a(met->pair), query.triangle_b(met->pair)).corner[0];
    }
    return met;
  });
}

}  // namespace graze
