#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/traverse/traversal.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query/candidates.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/query/wide_query.h>
#include <graze/engine/mesh/sweep/cast_directions.h>
#include <graze/engine/mesh/sweep/cast_nodes.h>
#include <graze/engine/mesh/sweep/earliest_meeting.h>
#include <graze/engine/mesh/sweep/swept_way.h>
#include <graze/narrowphase/motion/path_checks.h>
#include <graze/narrowphase/translation/displacement.h>
#include <graze/narrowphase/triangle_intersection.h>
#include <graze/narrowphase/triangle_triangle.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {
namespace {

Triangle placed_triangle(const PlacedMeshView& mesh, std::uint32_t index) {
  return narrowphase::place(mesh.pose, mesh.mesh.triangle(index));
}

/// What meets before anything moves.
void ask_start(const PlacedMeshView& a, const PlacedMeshView& b, EarliestMeeting& earliest,
               Work& work) {
  const WideQuery query(a, b, work);
  if (query.are_far_apart(work)) return;
  bvh::WidePairWalk walk = query.walk();
  Candidates candidates(Touch::Include, work);
  query.decide_all(walk, candidates, [&](TrianglePair pair) {
    earliest.ask_at_start(pair, placed_triangle(a, pair.a), placed_triangle(b, pair.b));
    return bvh::Walk::Continue;
  });
  add_counts(walk.counts(), work);
}

/// What meets later, of what is apart at t = 0: where a policy leaves contacts out, some of it may
/// not be. Depth first, the pair of nodes that can meet sooner before the other. What is found
/// bounds what is still looked at; of pairs that may meet as soon all are, as times decide exactly
/// and then indices.
class CastWalk {
 public:
  CastWalk(const PlacedMeshView& a, const PlacedMeshView& b, const contacts::SweepUnits& units,
           const SweptWay& way, StartContact start, EarliestMeeting& earliest, Work& work)
      : tree_a_(tree_of(a.mesh, &work)),
        tree_b_(tree_of(b.mesh, &work)),
        may_touch_(start == StartContact::IsLeft),
        way_(way),
        earliest_(earliest),
        work_(work),
        limit_(way.at(earliest.limit())),
        unit_a_(tree_a_.frame.unit() * units.per_metre),
        unit_b_(tree_b_.frame.unit() * units.per_metre),
        directions_({a}, {b}, units, way.direction),
        nodes_a_(Side::A, {a}, tree_a_, directions_, work),
        nodes_b_(Side::B, {b}, tree_b_, directions_, work) {}

  void run() {
    const Waiting root = waiting(0, 0, nodes_a_.span_of(0), nodes_b_.span_of(0));
    if (root.bound != kNever) open_.push(root);
    while (!open_.empty()) {
      const Waiting pair = open_.pop();
      if (pair.bound > limit_) continue;
      const bvh::Node &a = tree_a_.nodes[pair.a], &b = tree_b_.nodes[pair.b];
      if (a.is_leaf() && b.is_leaf()) {
        ask_leaves(pair.a, pair.b);
      } else if (b.is_leaf() ||
                 (!a.is_leaf() && half_size(a.box) * unit_a_ >= half_size(b.box) * unit_b_)) {
        const Span& of_b = nodes_b_.span_of(pair.b);
        const std::uint32_t one = a.first, other = a.first + 1;
        open(waiting(one, pair.b, nodes_a_.span_of(one), of_b),
             waiting(other, pair.b, nodes_a_.span_of(other), of_b));
      } else {
        const Span& of_a = nodes_a_.span_of(pair.a);
        const std::uint32_t one = b.first, other = b.first + 1;
        open(waiting(pair.a, one, of_a, nodes_b_.span_of(one)),
             waiting(pair.a, other, of_a, nodes_b_.span_of(other)));
      }
    }
  }

 private:
  using Side = contacts::CastDirections::Side;
  using Span = contacts::CastDirections::Span;
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  /// Two nodes, and no more than the translation at which something in them meets first.
  struct Waiting {
    std::uint32_t a;
    std::uint32_t b;
    double bound;
  };

  static double half_size(const bvh::FloatBox& box) {
    double size = 0;
    for (int k = 0; k < 3; ++k)
      size += double{box.max[k]} - box.min[k];
    return size;
  }

  Waiting waiting(std::uint32_t a, std::uint32_t b, const Span& of_a, const Span& of_b) {
    ++work_.volume_tests;
    const double bound = directions_.first_contact(of_a, of_b, limit_);
    work_.volume_rejections += bound == kNever;
    return {a, b, bound};
  }

  void open(Waiting near, Waiting far) {
    if (far.bound < near.bound) std::swap(near, far);
    if (far.bound != kNever) open_.push(far);
    if (near.bound != kNever) open_.push(near);
  }

  void ask_leaves(std::uint32_t node_a, std::uint32_t node_b) {
    const bvh::Node &leaf_a = tree_a_.nodes[node_a], &leaf_b = tree_b_.nodes[node_b];
    contacts::CastNodes::Leaf &in_a = nodes_a_.leaf(node_a), &in_b = nodes_b_.leaf(node_b);
    bool is_sooner = false;
    for (std::uint32_t i = 0; i < leaf_a.count; ++i) {
      for (std::uint32_t k = 0; k < leaf_b.count; ++k) {
        const double bound = directions_.first_contact(in_a.span[i], in_b.span[k], limit_);
        ++work_.filter_tests;
        if (bound == kNever || are_apart_by_planes(in_a, i, in_b, k)) continue;
        ++work_.triangle_tests;
        const TrianglePair pair{tree_a_.primitives[leaf_a.first + i],
                                tree_b_.primitives[leaf_b.first + k]};
        if (may_touch_ && bound <= 0 && do_meet(in_a.triangle[i], in_b.triangle[k])) continue;
        const bool is_first = earliest_.ask_later(pair, in_a.triangle[i], in_b.triangle[k]);
        if (!is_first) continue;
        is_sooner = true;
        limit_ = way_.at(earliest_.limit());
      }
    }
    if (!is_sooner) return;
    double normal[3];
    earliest_.rough_normal(normal);
    if (!directions_.take_normal(normal)) return;
    nodes_a_.take_normal();
    nodes_b_.take_normal();
  }

  /// Whether they meet later than the limit, or never: the plane of each triangle bounds that more
  /// closely than boxes do where surfaces face each other.
  bool are_apart_by_planes(contacts::CastNodes::Leaf& in_a, std::uint32_t i,
                           contacts::CastNodes::Leaf& in_b, std::uint32_t k) {
    const auto is_late = [&](Side side, const contacts::CastDirections::Plane& plane,
                             const Triangle& other) {
      return directions_.first_contact(side, plane, other, limit_) == kNever;
    };
    return is_late(Side::A, nodes_a_.plane(in_a, i), in_b.triangle[k]) ||
           is_late(Side::B, nodes_b_.plane(in_b, k), in_a.triangle[i]);
  }

  bool do_meet(const Triangle& a, const Triangle& b) {
    const narrowphase::Decision decision = narrowphase::decide(a, b);
    work_.exact_tests += decision.stage == narrowphase::Stage::Exact;
    return decision.is_hit;
  }

  const bvh::Tree& tree_a_;
  const bvh::Tree& tree_b_;
  bool may_touch_;
  const SweptWay& way_;
  EarliestMeeting& earliest_;
  Work& work_;
  double limit_;
  double unit_a_;
  double unit_b_;
  contacts::CastDirections directions_;
  contacts::CastNodes nodes_a_;
  contacts::CastNodes nodes_b_;
  bvh::TraversalStack<Waiting, 256> open_;
};

}  // namespace

std::optional<MeshCast> cast(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                             const Eigen::Vector3d& displacement, const CastSettings& settings,
                             Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<MeshCast> {
    CountedWork counted(work);
    narrowphase::check_settings(settings);
    check_placement(mesh_a.pose, mesh_a.mesh.bounds(), "pose of mesh A");
    check_placement(mesh_b.pose, mesh_b.mesh.bounds(), "pose of mesh B");
    narrowphase::check_displacement(displacement);
    const contacts::SweepUnits units(mesh_a, mesh_b);
    const SweptWay way(displacement, units);
    EarliestMeeting earliest(displacement.data(), settings.start);
    ask_start(mesh_a, mesh_b, earliest, counted.work());
    if (!earliest.is_at_start() && way.is_any())
      CastWalk(mesh_a, mesh_b, units, way, settings.start, earliest, counted.work()).run();
    std::optional<MeshCast> met = earliest.result();
    if (met && met->is_at_start) {
      met->point =
          intersection(placed_triangle(mesh_a, met->pair.a), placed_triangle(mesh_b, met->pair.b))
              .corner[0];
    }
    return met;
  });
}

}  // namespace graze
