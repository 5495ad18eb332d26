// A ray in the frame of a mesh's tree, by the derivation of relative_frame.cpp, whose names these
// are. A point p of a placed triangle has y = R^T (p - P) within 3 dev r + 3.5 placing of the
// node's box, and one of the ray, o + s d, has y = R^T (o - P) + s R^T d. The first term as
// computed is off by 10 u |o - P|, components of the second, |d| being less than 4, by 28 u;
// RaySlabs takes components below 2^-60 for 0. A ray point near enough to meet the mesh has s < 4 r
// + 4 |R^T (o - P)|, as the largest component of R^T d is more than 1/2. So 3 dev r + 4 placing +
// 256 u (r + |o - P|) covers all.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/traverse/traverse_nearest.h>
#include <graze/bvh/value/ray_slabs.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/mesh_ray.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/narrowphase/ray/ray_stages.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {
namespace {

constexpr double kUnitRoundoff = 0x1p-53;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double largest_component(const double* v) {
  return std::max(std::abs(v[0]), std::max(std::abs(v[1]), std::abs(v[2])));
}

/// The ray in the units of a tree's frame.
class RayInFrame {
 public:
  RayInFrame(const PlacedMeshView& placed, double deviation, const bvh::LocalFrame& frame,
             const narrowphase::PreparedRay& ray)
      : per_metre_(std::ldexp(1.0, -frame.exponent)), length_(ray.scaled.length) {
    const double* m = placed.pose.data();  // column-major 4x4
    const Eigen::Vector3d centre = narrowphase::place(
        placed.pose, Eigen::Vector3d(frame.centre[0], frame.centre[1], frame.centre[2]));
    double offset[3], origin[3], direction[3];
    for (int i = 0; i < 3; ++i)
      offset[i] = ray.ray.origin.data()[i] - centre.data()[i];
    for (int i = 0; i < 3; ++i) {
      const double* axis = m + 4 * i;
      const double* d = ray.scaled.component;
      origin[i] = ((axis[0] * offset[0] + axis[1] * offset[1]) + axis[2] * offset[2]) * per_metre_;
      direction[i] = (axis[0] * d[0] + axis[1] * d[1]) + axis[2] * d[2];
    }
    slabs_ = {origin, direction};
    const Aabb& bounds = placed.mesh.bounds();
    const double largest =
        std::max(largest_component(bounds.min.data()), largest_component(bounds.max.data()));
    const double placing = 8 * kUnitRoundoff * (largest + largest_component(m + 12)) + 0x1p-1070;
    const double radius = 2 * frame.unit();
    const double metres = 3 * (deviation + 8 * kUnitRoundoff) * radius + 4 * placing +
                          256 * kUnitRoundoff * (radius + largest_component(offset));
    slack_ = 1.01 * (metres * per_metre_) + 0x1p-900;
    is_blind_ = !std::isfinite(slack_) || !std::isfinite(largest_component(origin));
  }

  /// As bvh::entry(). What could overflow prunes nothing.
  double entry(const bvh::FloatBox& box, double limit) const {
    if (is_blind_) return 0;
    double low[3], high[3];
    for (int k = 0; k < 3; ++k) {
      low[k] = box.min[k] - slack_;
      high[k] = box.max[k] + slack_;
    }
    return bvh::entry(slabs_, low, high, limit);
  }

  /// The parameter before which all is at most that far away, metres.
  double limit_for(double distance) const {
    return distance / length_ * per_metre_ * (1 + 0x10p-53) + 0x1p-1050;
  }

 private:
  double per_metre_;
  double length_;
  bvh::RaySlabs slabs_;
  double slack_;
  bool is_blind_;
};

/// Where the ray enters the nodes' boxes, for traverse_nearest().
struct EntryBounds {
  const bvh::Tree& tree;
  const RayInFrame& ray;
  const double& limit;  ///< comes down when a hit is found
  Work& work;

  double of(std::uint32_t node) const {
    ++work.volume_tests;
    const double entry = ray.entry(tree.nodes[node].box, limit);
    work.volume_rejections += entry == bvh::kNever;
    return entry;
  }
  bool is_missed(double entry) const { return entry == bvh::kNever; }
  bool is_beyond(double entry) const { return entry > limit; }
};

/// Calls `on_hit(hit)` for each placed triangle that the ray meets before a limit, metres, to which
/// that comes down when it returns one.
template <typename OnHit>
void for_each_hit(const PlacedMeshView& placed, const Ray& ray, Work& work, OnHit&& on_hit) {
  check_ray(ray, "ray");
  const double deviation = check_placement(placed.pose, placed.mesh.bounds(), "pose of the mesh");
  const bvh::Tree& tree = tree_of(placed.mesh, &work);
  const narrowphase::PreparedRay prepared(ray);
  const RayInFrame in_frame(placed, deviation, tree.frame, prepared);
  double limit = in_frame.limit_for(ray.max_distance);
  const EntryBounds bounds{tree, in_frame, limit, work};
  const auto leaf_fn = [&](const bvh::Node& leaf) {
    for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
      const std::uint32_t index = tree.primitives[i];
      narrowphase::Stage stage;
      ++work.triangle_tests;
      const auto found = narrowphase::cast_ray(
          narrowphase::place(placed.pose, placed.mesh.triangle(index)), prepared, stage);
      work.exact_tests += stage == narrowphase::Stage::Exact;
      if (!found) continue;
      const double wanted = on_hit(RayHit{found->distance, found->point, found->normal, index});
      limit = std::min(limit, in_frame.limit_for(wanted));
    }
    return bvh::Walk::Continue;
  };
  bvh::traverse_nearest(tree, bounds, leaf_fn);
}

bool is_before(const RayHit& s, const RayHit& t) {
  if (s.distance != t.distance) return s.distance < t.distance;
  return s.triangle < t.triangle;
}

}  // namespace

std::optional<RayHit> cast_ray(const PlacedMeshView& mesh, const Ray& ray, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<RayHit> {
    CountedWork counted(work);
    std::optional<RayHit> first;
    for_each_hit(mesh, ray, counted.work(), [&](const RayHit& hit) {
      if (!first || is_before(hit, *first)) first = hit;
      return first->distance;
    });
    return first;
  });
}

std::vector<RayHit> cast_ray_all(const PlacedMeshView& mesh, const Ray& ray, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<RayHit> {
    CountedWork counted(work);
    std::vector<RayHit> hits;
    for_each_hit(mesh, ray, counted.work(), [&](const RayHit& hit) {
      hits.push_back(hit);
      return kInfinity;
    });
    std::sort(hits.begin(), hits.end(), is_before);
    return hits;
  });
}

}  // namespace graze
