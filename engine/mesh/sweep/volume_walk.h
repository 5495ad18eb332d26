#pragma once

#include <graze/bvh/traverse/traverse_nearest.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/sweep/cast_nodes.h>
#include <graze/engine/mesh/sweep/sweep_line.h>
#include <graze/engine/work.h>

#include <limits>

namespace graze {

/// The bound of what is never met: no bound of a cast is above it.
inline constexpr double kNeverMet = std::numeric_limits<double>::infinity();

/// The bounds of a translation, in the units of a sweep: a triangle is met no earlier than `low`,
/// and what is met later than `limit` is of no interest.
struct MeetingBounds {
  double low;
  double limit;
};

/// The walk of something simple that goes straight over the tree of a mesh, for traverse_nearest():
/// what may be met sooner first. `mover` is what goes:
///
///   span()        it, along the directions
///   limit()       no less than the earliest time that it has found, or 1
///   ask(index, placed, span, bounds)
///                 about a triangle of the mesh: true if that is the earliest so far
///   turn(directions)
///                 whether it has found another direction to ask along; its spans are new then
template <typename Mover>
class VolumeWalk {
 public:
  VolumeWalk(const contacts::FramedMesh& mesh, contacts::CastDirections& directions,
             const SweepLine& line, Mover& mover, Work& work)
      : tree_(tree_of(mesh.placed.mesh, &work)),
        directions_(directions),
        line_(line),
        mover_(mover),
        work_(work),
        limit_(line.at(mover.limit())),
        nodes_(mesh, tree_, directions, work) {}

  void run() {
    bvh::traverse_nearest(tree_, *this, [&](const bvh::Node& leaf) {
      ask_leaf(static_cast<std::uint32_t>(&leaf - tree_.nodes.data()));
      return bvh::Walk::Continue;
    });
  }

  double of(std::uint32_t node) {
    ++work_.volume_tests;
    const double bound = directions_.first_contact(nodes_.span_of(node), mover_.span(), limit_);
    work_.volume_rejections += bound == kNeverMet;
    return bound;
  }
  static bool is_missed(double bound) { return bound == kNeverMet; }
  bool is_beyond(double bound) const { return bound > limit_; }

 private:
  void ask_leaf(std::uint32_t node) {
    const bvh::Node& leaf = tree_.nodes[node];
    const contacts::CastNodes::Leaf& in_leaf = nodes_.leaf(node);
    bool is_sooner = false;
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
      const double bound = directions_.first_contact(in_leaf.span[i], mover_.span(), limit_);
      if (bound == kNeverMet) continue;
      ++work_.triangle_tests;
      if (!mover_.ask(tree_.primitives[leaf.first + i], in_leaf.triangle[i], in_leaf.span[i],
                      {bound, limit_}))
        continue;
      is_sooner = true;
      limit_ = line_.at(mover_.limit());
    }
    if (is_sooner && mover_.turn(directions_)) nodes_.take_normal();
  }

  const bvh::Tree& tree_;
  contacts::CastDirections& directions_;
  const SweepLine& line_;
  Mover& mover_;
  Work& work_;
  double limit_;
  contacts::CastNodes nodes_;
};

}  // namespace graze
