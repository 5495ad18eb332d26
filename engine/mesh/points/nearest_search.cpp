// A point is handed to relative_frame() as a flat box in a frame of its own, so that the slack of
// law 5 covers how far off it lies in the mesh's frame, and DistanceLimit what that means for
// distances: a bound of a node is the length of the gaps between its box and the point, less that
// slack along each axis. It rounds less than the 16 u that DistanceLimit allows.

#include <graze/bvh/traverse/traverse_nearest.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/nearest/distance_limit.h>
#include <graze/engine/mesh/nearest/distance_parts.h>
#include <graze/engine/mesh/points/nearest_search.h>
#include <graze/narrowphase/derived/directed_gap.h>
#include <graze/narrowphase/derived/point_distance.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {

/// One search, with the answers to traverse_nearest() and the best point so far.
class NearestSearch::Descent {
 public:
  Descent(const NearestSearch& search, const Eigen::Vector3d& point)
      : search_(search),
        point_{point, point, point},
        framed_(framed(point, search.frame_)),
        gap_(std::max(search.largest_, point.cwiseAbs().maxCoeff())) {}

  /// Returns the bound of a node, squared, in common units. These are those of the mesh's tree: a
  /// flat box has the least of all.
  double of(std::uint32_t node) const {
    ++search_.work_.volume_tests;
    const bvh::FloatBox& box = search_.tree_.nodes[node].box;
    const double(&at)[3] = framed_.relative.translation;
    double square = 0;
    for (int k = 0; k < 3; ++k) {
      const double gap = std::max(static_cast<double>(box.min[k]) - at[k],
                                  at[k] - static_cast<double>(box.max[k])) -
                         framed_.relative.slack;
      // There is no branch, which nobody could foresee. What is no number prunes nothing.
      const double positive = std::max(gap, 0.0);
      square += positive * positive;
    }
    return square;
  }
  bool is_missed(double bound) const { return is_beyond(bound); }
  bool is_beyond(double bound) const {
    const bool is_pruned = bound > square_;
    search_.work_.volume_rejections += is_pruned;
    return is_pruned;
  }

  void look_at(std::uint32_t index) {
    const Triangle triangle = search_.triangles_[index];
    if (gap_.is_beyond(best_.distance, gap_.end_of(point_), gap_.start_of(triangle))) return;
    const narrowphase::PointDistance found = narrowphase::decide_distance(point_.a, triangle);
    ++search_.work_.triangle_tests;
    search_.work_.exact_tests += found.stage == narrowphase::Stage::Exact;
    if (found.distance > best_.distance ||
        (found.distance == best_.distance && index >= best_.triangle))
      return;
    best_ = {found.distance, found.nearest, index};
    framed_.limit.shrink_to(found.distance);
    square_ = framed_.limit.square();
    gap_.set_direction({found.distance, point_.a, found.nearest, Feature::Vertex, found.feature});
  }

  const NearestPoint& best() const { return best_; }

 private:
  /// The point in the frame of the placed mesh, as a flat box.
  struct Framed {
    bvh::RelativeFrame relative;
    DistanceLimit limit;
  };

  static Framed framed(const Eigen::Vector3d& point, const PlacedFrame& mesh) {
    const Aabb box{point, point};
    const Pose identity = Pose::Identity();
    const bvh::LocalFrame local = bvh::LocalFrame::around(box);
    const PlacedFrame frame(identity, 0, local, box);
    const bvh::RelativeFrame relative = relative_frame(mesh, frame);
    return {relative, {mesh, frame, relative}};
  }

  const NearestSearch& search_;
  Triangle point_;
  Framed framed_;
  narrowphase::DirectedGap gap_;
  double square_ = std::numeric_limits<double>::infinity();
  NearestPoint best_{std::numeric_limits<double>::infinity(), Eigen::Vector3d::Zero(),
                     std::numeric_limits<std::uint32_t>::max()};
};

NearestSearch::NearestSearch(const PlacedMeshView& placed, double deviation, Work& work)
    : tree_(tree_of(placed.mesh, &work)),
      frame_(placed.pose, deviation, tree_.frame, placed.mesh.bounds()),
      triangles_(placed),
      largest_(largest_of(placed)),
      work_(work) {}

NearestPoint NearestSearch::nearest_to(const Eigen::Vector3d& point,
                                       std::optional<std::uint32_t> hint) {
  Descent descent(*this, point);
  if (hint) descent.look_at(*hint);
  bvh::traverse_nearest(tree_, descent, [&](const bvh::Node& leaf) {
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i)
      descent.look_at(tree_.primitives[i]);
    return bvh::Walk::Continue;
  });
  return descent.best();
}

}  // namespace graze
