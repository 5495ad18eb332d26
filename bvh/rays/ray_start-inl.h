// Where a ray's walk begins, and what it needs of the ray. Included once for each SIMD target.

#if defined(GRAZE_BVH_RAY_START) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_RAY_START
#undef GRAZE_BVH_RAY_START
#else
#define GRAZE_BVH_RAY_START
#endif

#include <graze/bvh/rays/ray_limits.h>
#include <graze/bvh/rays/ray_tree_walk.h>
#include <graze/bvh/value/ray_slabs.h>
#include <hwy/highway.h>

#include <bit>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using StartTag = hn::CappedTag<double, 4>;

// Derived in ray_tree_walk.h.
inline constexpr double kBoxRounding = 0x1p-18;
inline constexpr double kLeastComponent = 0x1p-30;

// What coordinates of corners, lean and origin are off by as doubles, times what they are
// multiplied with: 16 u of what is below 2^4 and the slack.
inline constexpr double kExactRounding = 0x1p-44;

// More slack than that, and nothing is pruned; further away there is as much.
inline constexpr double kMostSlack = 0x1p20;
inline constexpr double kFarthestOrigin = 0x1p200;

// By how far a ray is elsewhere for each metre from the tree's centre
// (engine/mesh/probe/mesh_ray.cpp).
inline constexpr double kRaySlack = 256 * 0x1p-53;

/// The ray in the tree's frame.
struct LocalRay {
  alignas(32) double origin[4];
  alignas(32) double direction[4];
  double slack;

  HWY_INLINE explicit LocalRay(const RayToWalk& ray) {
    const StartTag tag;
    const RayFrame& frame = ray.frame;
    double offset[3];
    for (std::size_t k = 0; k < 3; ++k)
      offset[k] = ray.origin[k] - frame.centre[k];
    for (std::size_t i = 0; i < 4; i += hn::Lanes(tag)) {
      const auto x = hn::Load(tag, frame.columns[0] + i);
      const auto y = hn::Load(tag, frame.columns[1] + i);
      const auto z = hn::Load(tag, frame.columns[2] + i);
      const auto turned = [&](const double* v) HWY_ATTR {
        return hn::Add(hn::Add(hn::Mul(x, hn::Set(tag, v[0])), hn::Mul(y, hn::Set(tag, v[1]))),
                       hn::Mul(z, hn::Set(tag, v[2])));
      };
      hn::Store(hn::Mul(turned(offset), hn::Set(tag, frame.per_metre)), tag, origin + i);
      hn::Store(turned(ray.direction), tag, direction + i);
    }
    const double far =
        HWY_MAX(HWY_MAX(std::abs(offset[0]), std::abs(offset[1])), std::abs(offset[2]));
    const double metres = frame.slack + kRaySlack * far;
    slack = 1.01 * (metres * frame.per_metre) + 0x1p-900;
  }
};

/// entry() at the box of all, and what remains of RaySlabs.
struct RayEntry {
  double enter;
  alignas(32) double inverse[4];

  HWY_INLINE RayEntry(const RayTree& tree, const LocalRay& ray, double limit) {
    const StartTag tag;
    alignas(32) double near[4], far[4];
    const auto slack = hn::Set(tag, ray.slack);
    const auto one = hn::Set(tag, 1.0);
    const auto infinity = hn::Set(tag, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < 4; i += hn::Lanes(tag)) {
      const auto o = hn::Load(tag, ray.origin + i), d = hn::Load(tag, ray.direction + i);
      const auto low = hn::Sub(hn::Load(tag, tree.low + i), slack);
      const auto high = hn::Add(hn::Load(tag, tree.high + i), slack);
      const auto is_parallel = hn::Lt(hn::Abs(d), hn::Set(tag, kParallel));
      const auto per_unit = hn::Div(one, hn::IfThenElse(is_parallel, one, d));
      const auto at_low = hn::Mul(hn::Sub(low, o), per_unit);
      const auto at_high = hn::Mul(hn::Sub(high, o), per_unit);
      const auto is_outside = hn::Or(hn::Lt(o, low), hn::Gt(o, high));
      const auto anywhere = hn::IfThenElse(is_outside, hn::Neg(one), infinity);
      hn::Store(per_unit, tag, inverse + i);
      hn::Store(hn::IfThenElse(is_parallel, hn::Neg(infinity), hn::Min(at_low, at_high)), tag,
                near + i);
      hn::Store(hn::IfThenElse(is_parallel, anywhere, hn::Max(at_low, at_high)), tag, far + i);
    }
    const double last = HWY_MAX(near[0], HWY_MAX(near[1], near[2]));
    const double first = HWY_MIN(far[0], HWY_MIN(far[1], far[2]));
    enter = surely_entered(HWY_MAX(last, 0.0), HWY_MIN(first, limit));
  }
};

/// What boxes are asked with.
HWY_INLINE void start_boxes(const LocalRay& ray, const RayEntry& entry, RayWalkState& state) {
  const StartTag tag;
  const hn::Rebind<float, StartTag> floats;
  for (std::size_t i = 0; i < 4; i += hn::Lanes(tag)) {
    const auto d = hn::Load(tag, ray.direction + i);
    const auto at = hn::Add(hn::Load(tag, ray.origin + i), hn::Mul(hn::Set(tag, entry.enter), d));
    hn::Store(at, tag, state.exact_origin + i);
    hn::Store(hn::DemoteTo(floats, at), floats, state.origin + i);
    const auto is_small = hn::Lt(hn::Abs(d), hn::Set(tag, kLeastComponent));
    const auto inverse =
        hn::IfThenElse(is_small, hn::CopySign(hn::Set(tag, 1 / kLeastComponent), d),
                       hn::Load(tag, entry.inverse + i));
    hn::Store(hn::DemoteTo(floats, inverse), floats, state.inverse + i);
  }
  state.padding = static_cast<float>(1.01 * (ray.slack + kBoxRounding * (1 + ray.slack)));
  for (std::uint8_t k = 0; k < 3; ++k) {
    const std::uint32_t is_backwards = std::bit_cast<std::uint32_t>(state.inverse[k]) >> 31;
    state.near_row[k] = static_cast<std::uint8_t>(k + 3 * is_backwards);
    state.far_row[k] = static_cast<std::uint8_t>(k + 3 - 3 * is_backwards);
  }
}

/// What leaves are asked with.
HWY_INLINE void start_leaves(const LocalRay& ray, const RayEntry& entry, RayWalkState& state) {
  const double x = std::abs(ray.direction[0]), y = std::abs(ray.direction[1]),
               z = std::abs(ray.direction[2]);
  const std::size_t most = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
  constexpr std::uint8_t kAxes[3][3] = {{1, 2, 0}, {2, 0, 1}, {0, 1, 2}};
  for (std::size_t i = 0; i < 3; ++i)
    state.axis[i] = kAxes[most][i];
  state.along = entry.inverse[most];
  for (std::size_t i = 0; i < 2; ++i)
    state.lean[i] = ray.direction[state.axis[i]] * state.along;
  // A lean is at most 1, and a unit of an axis at most 2 of s.
  state.leaf_slack = static_cast<float>(1.01 * (2 * ray.slack + kExactRounding * (1 + ray.slack)));
}

HWY_INLINE void start_walk(const RayTree& tree, const RayToWalk& ray, RayWalkState& state) {
  const LocalRay local(ray);
  state.open_count = 0;
  // A NaN compares as false.
  state.is_blind =
      !(local.slack < kMostSlack && std::abs(local.origin[0]) < kFarthestOrigin &&
        std::abs(local.origin[1]) < kFarthestOrigin && std::abs(local.origin[2]) < kFarthestOrigin);
  if (state.is_blind) return;
  const RayEntry entry(tree, local, ray.limit);
  if (entry.enter == kNever) return;
  state.start = entry.enter;
  state.aim = ray.aim;
  state.rows = ray.rows;
  state.row_size = ray.row_size;
  start_boxes(local, entry, state);
  start_leaves(local, entry, state);
  state.limit = ray_limit(ray.limit, state.start);
  state.sure_limit = sure_ray_limit(ray.limit, state.start);
  state.open_count = 1;
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
