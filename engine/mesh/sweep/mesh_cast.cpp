#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/traverse/traversal.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/sweep/earliest_meeting.h>
#include <graze/engine/mesh/sweep/swept_nodes.h>
#include <graze/narrowphase/motion/path_checks.h>
#include <graze/narrowphase/translation/displacement.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {
namespace {

/// A displacement as a sweep takes it: its direction d, with a largest component from 1/2 to 1 in
/// size, scaled by a power of two, so that the translation at a time is s d for s = t 2^exponent in
/// units of the sweep. A component that underflows is off by less than 2^-1074, while s is below 7:
/// the margins cover that.
struct SweptWay {
  double direction[3] = {0, 0, 0};
  int exponent = 0;

  SweptWay(const Eigen::Vector3d& displacement, const contacts::SweepUnits& units) {
    const double* d = displacement.data();
    const double largest = std::max(std::abs(d[0]), std::max(std::abs(d[1]), std::abs(d[2])));
    if (largest == 0) return;
    const int own = std::ilogb(largest) + 1;
    for (int k = 0; k < 3; ++k)
      direction[k] = std::ldexp(d[k], -own);
    exponent = own - std::ilogb(units.metres);
  }

  /// No less than s at a time that is no later.
  double at(double time) const {
    if (time == 0) return 0;
    return std::nextafter(std::ldexp(time, exponent), std::numeric_limits<double>::infinity());
  }
};

/// Depth first, the pair of nodes that can meet sooner before the other. What is found bounds what
/// is still looked at; of pairs that may meet as soon all are, as times decide exactly and then
/// indices.
class CastWalk {
 public:
  CastWalk(const PlacedMeshView& a, const PlacedMeshView& b, const contacts::SweepUnits& units,
           const SweptWay& way, EarliestMeeting& earliest, Work& work)
      : a_(a),
        b_(b),
        tree_a_(tree_of(a.mesh, &work)),
        tree_b_(tree_of(b.mesh, &work)),
        swept_(a, b, units, way.direction),
        way_(way),
        earliest_(earliest),
        work_(work),
        limit_(way.at(earliest.limit())) {}

  void run() {
    const Waiting root = waiting(0, 0);
    if (root.bound != kNever) open_.push(root);
    while (!open_.empty()) {
      const Waiting pair = open_.pop();
      if (pair.bound > limit_) continue;
      const bvh::Node &a = tree_a_.nodes[pair.a], &b = tree_b_.nodes[pair.b];
      if (a.is_leaf() && b.is_leaf()) {
        ask_leaves(a, b, pair.bound);
      } else if (b.is_leaf() || (!a.is_leaf() && swept_.size_a(a.box) >= swept_.size_b(b.box))) {
        open(waiting(a.first, pair.b), waiting(a.first + 1, pair.b));
      } else {
        open(waiting(pair.a, b.first), waiting(pair.a, b.first + 1));
      }
    }
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  /// Two nodes, and no more than the translation at which something in them meets first.
  struct Waiting {
    std::uint32_t a;
    std::uint32_t b;
    double bound;
  };

  Waiting waiting(std::uint32_t a, std::uint32_t b) {
    ++work_.volume_tests;
    const double bound = swept_.first_contact(tree_a_.nodes[a].box, tree_b_.nodes[b].box, limit_);
    work_.volume_rejections += bound == kNever;
    return {a, b, bound};
  }

  void open(Waiting near, Waiting far) {
    if (far.bound < near.bound) std::swap(near, far);
    if (far.bound != kNever) open_.push(far);
    if (near.bound != kNever) open_.push(near);
  }

  void ask_leaves(const bvh::Node& leaf_a, const bvh::Node& leaf_b, double bound) {
    for (std::uint32_t i = leaf_a.first; i < leaf_a.first + leaf_a.count; ++i) {
      const std::uint32_t of_a = tree_a_.primitives[i];
      const Triangle a = narrowphase::place(a_.pose, a_.mesh.triangle(of_a));
      for (std::uint32_t k = leaf_b.first; k < leaf_b.first + leaf_b.count; ++k) {
        const std::uint32_t of_b = tree_b_.primitives[k];
        const Triangle b = narrowphase::place(b_.pose, b_.mesh.triangle(of_b));
        ++work_.triangle_tests;
        if (bound > 0) {
          earliest_.ask_later({of_a, of_b}, a, b);
        } else {
          earliest_.ask_from_start({of_a, of_b}, a, b, work_);
        }
      }
    }
    limit_ = way_.at(earliest_.limit());
  }

  const PlacedMeshView& a_;
  const PlacedMeshView& b_;
  const bvh::Tree& tree_a_;
  const bvh::Tree& tree_b_;
  contacts::SweptNodes swept_;
  const SweptWay& way_;
  EarliestMeeting& earliest_;
  Work& work_;
  double limit_;
  bvh::TraversalStack<Waiting, 256> open_;
};

}  // namespace

std::optional<MeshCast> cast(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                             const Eigen::Vector3d& displacement,
                             const FirstContactSettings& settings, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<MeshCast> {
    CountedWork counted(work);
    narrowphase::check_settings(settings);
    check_placement(mesh_a.pose, mesh_a.mesh.bounds(), "pose of mesh A");
    check_placement(mesh_b.pose, mesh_b.mesh.bounds(), "pose of mesh B");
    narrowphase::check_displacement(displacement);
    const contacts::SweepUnits units(mesh_a, mesh_b);
    const SweptWay way(displacement, units);
    EarliestMeeting earliest(displacement.data(), settings.start);
    CastWalk(mesh_a, mesh_b, units, way, earliest, counted.work()).run();
    return earliest.result();
  });
}

}  // namespace graze
