// This begins a ray's walk, and computes what the walk needs of the ray. It is included once for
// each SIMD target.

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

// These are derived in ray_tree_walk.h.
inline constexpr double kBoxRounding = 0x1p-19;
inline constexpr double kLeastComponent = 0x1p-30;

inline constexpr float kGridStep = 1.0f / 1023;

// Coordinates of corners, lean and origin are off by this as doubles, times what they are
// multiplied with: 16 u of what is below 2^4 and the slack.
inline constexpr double kExactRounding = 0x1p-44;

// With more slack than this nothing is pruned. There is as much where the ray begins further away
// than 2^65.
inline constexpr double kMostSlack = 0x1p20;

// A ray may be elsewhere by this share of its distance from the tree's centre
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

/// The answer of entry() for the box of all. A component below kParallel is taken for that, which
/// moves the ray by less than its slack.
struct RayEntry {
  double enter;
  alignas(32) double inverse[4];

  HWY_INLINE RayEntry(const RayTree& tree, const LocalRay& ray, double limit) {
    const StartTag tag;
    alignas(32) double near[4], far[4];
    const auto slack = hn::Set(tag, ray.slack);
    for (std::size_t i = 0; i < 4; i += hn::Lanes(tag)) {
      const auto o = hn::Load(tag, ray.origin + i), d = hn::Load(tag, ray.direction + i);
      const auto kept = hn::CopySign(hn::Max(hn::Abs(d), hn::Set(tag, kParallel)), d);
      const auto per_unit = hn::Div(hn::Set(tag, 1.0), kept);
      const auto low = hn::Sub(hn::Load(tag, tree.low + i), slack);
      const auto high = hn::Add(hn::Load(tag, tree.high + i), slack);
      const auto at_low = hn::Mul(hn::Sub(low, o), per_unit);
      const auto at_high = hn::Mul(hn::Sub(high, o), per_unit);
      hn::Store(per_unit, tag, inverse + i);
      hn::Store(hn::Min(at_low, at_high), tag, near + i);
      hn::Store(hn::Max(at_low, at_high), tag, far + i);
    }
    const double last = HWY_MAX(near[0], HWY_MAX(near[1], near[2]));
    const double first = HWY_MIN(far[0], HWY_MIN(far[1], far[2]));
    enter = surely_entered(HWY_MAX(last, 0.0), HWY_MIN(first, limit));
  }
};

/// Fills in the numbers that boxes are compared with. `origin` becomes the point where the walk
/// starts.
HWY_INLINE void start_boxes(const LocalRay& ray, const RayEntry& entry, RayWalkState& state,
                            double* origin) {
  const StartTag tag;
  const hn::Rebind<float, StartTag> floats;
  const auto padding =
      hn::Set(floats, static_cast<float>(1.01 * (ray.slack + kBoxRounding * (1 + ray.slack))));
  for (std::size_t i = 0; i < 4; i += hn::Lanes(tag)) {
    const auto along = hn::Mul(hn::Set(tag, entry.enter), hn::Load(tag, ray.direction + i));
    const auto start = hn::Add(hn::Load(tag, ray.origin + i), along);
    hn::Store(start, tag, origin + i);
    const auto most = hn::Set(tag, 1 / kLeastComponent);
    const auto kept = hn::Clamp(hn::Load(tag, entry.inverse + i), hn::Neg(most), most);
    const auto inverse = hn::DemoteTo(floats, kept);
    const auto at_origin = hn::Mul(hn::DemoteTo(floats, start), inverse);
    const auto padded = hn::Mul(hn::Abs(inverse), padding);
    hn::Store(inverse, floats, state.inverse + i);
    hn::Store(hn::Sub(hn::Neg(at_origin), padded), floats, state.near + i);
    hn::Store(hn::Sub(padded, at_origin), floats, state.far + i);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t is_backwards = std::bit_cast<std::uint32_t>(state.inverse[k]) >> 31;
    state.near_row[k] = (2 * k + is_backwards) * RayNode::kWidth;
    state.far_row[k] = state.near_row[k] ^ RayNode::kWidth;
  }
}

constexpr RayAxes axes_for(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  const std::uint32_t axis[3] = {x, y, z};
  RayAxes axes{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t first_bit = RayTree::kBits * axis[i];
    axes.axis[i] = axis[i];
    axes.row[i] = 2 * RayNode::kWidth * axis[i];
    axes.mask[i] = RayTree::kSteps << first_bit;
    axes.per_bit[i] = kGridStep / static_cast<float>(1u << first_bit);
  }
  return axes;
}
inline constexpr RayAxes kRayAxes[3] = {axes_for(1, 2, 0), axes_for(2, 0, 1), axes_for(0, 1, 2)};

/// Fills in the numbers that leaves are compared with.
HWY_INLINE void start_leaves(const LocalRay& ray, const RayEntry& entry, const double* origin,
                             RayWalkState& state) {
  const double x = std::abs(ray.direction[0]), y = std::abs(ray.direction[1]),
               z = std::abs(ray.direction[2]);
  // There is no branch, which would be mispredicted where rays go anywhere.
  const std::size_t is_z = static_cast<std::size_t>(z > x) & static_cast<std::size_t>(z > y);
  const std::size_t most = 2 * is_z | (static_cast<std::size_t>(y > x) & ~is_z);
  const RayAxes& axes = kRayAxes[most];
  state.axes = &axes;
  state.along = entry.inverse[most];
  state.float_along = static_cast<float>(state.along);
  for (std::size_t i = 0; i < 3; ++i)
    state.origin[i] = origin[axes.axis[i]];
  for (std::size_t i = 0; i < 2; ++i) {
    state.lean[i] = ray.direction[axes.axis[i]] * state.along;
    state.minus_lean[i] = -static_cast<float>(state.lean[i]);
  }
  // A lean is at most 1, and a unit of an axis at most 2 of s.
  state.leaf_slack = static_cast<float>(1.01 * (2 * ray.slack + kExactRounding * (1 + ray.slack)));
}

HWY_INLINE void start_walk(const RayTree& tree, const RayToWalk& ray, RayWalkState& state) {
  const LocalRay local(ray);
  state.open_count = 0;
  state.counts = {};
  // A NaN compares as false.
  state.is_blind = !(local.slack < kMostSlack && tree.node_count != 0);
  if (state.is_blind) return;
  const RayEntry entry(tree, local, ray.limit);
  if (entry.enter == kNever) return;
  state.start = entry.enter;
  state.aim = ray.aim;
  state.primitives = ray.primitives;
  alignas(32) double origin[4];
  start_boxes(local, entry, state, origin);
  start_leaves(local, entry, origin, state);
  if (ray.limit == std::numeric_limits<double>::infinity()) [[likely]] {
    state.limit = state.sure_limit = static_cast<float>(kFarthest);
  } else {
    state.limit = ray_limit(ray.limit, state.start);
    state.sure_limit = sure_ray_limit(ray.limit, state.start);
  }
  state.open_count = 1;
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
