// Asks the remaining axes of the separating axis test of triangle and box, for each SIMD target
// that the compiler knows: the three edges at once where four doubles fit, two axes at once
// elsewhere. Both do the same operations and none is fused, so that all targets round alike. The
// bounds are in remaining_axes.h.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "graze/narrowphase/triangle_box/remaining_axes.cpp"
#include <hwy/foreach_target.h>  // compiles this file once more for each target

#include <graze/narrowphase/lanes/two_lanes.h>
#include <graze/narrowphase/lanes/verdicts.h>
#include <graze/narrowphase/triangle_box/remaining_axes.h>
#include <hwy/highway.h>
#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace graze::narrowphase::HWY_NAMESPACE {
namespace {

#if HWY_MAX_BYTES >= 32

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, 4>;
using Lanes = hn::Vec<Tag>;

/// Holds one coordinate of the corners a, b, c, and c again.
struct Corners {
  Lanes x, y, z;
};

HWY_INLINE Corners corners(const double* t) {
  const Tag tag;
  const Lanes a = hn::LoadU(tag, t);
  const Lanes b = hn::LoadU(tag, t + 3);
  const Lanes xz = hn::InterleaveLower(tag, a, b);
  const Lanes yx = hn::InterleaveUpper(tag, a, b);
  return {hn::ConcatLowerLower(tag, hn::Set(tag, t[6]), xz),
          hn::ConcatLowerLower(tag, hn::Set(tag, t[7]), yx),
          hn::ConcatLowerUpper(tag, hn::Set(tag, t[8]), xz)};
}

/// Returns the edges from each corner to the next.
HWY_INLINE Lanes edges(Lanes corner) {
  alignas(32) constexpr std::int64_t kNext[4] = {1, 2, 0, 0};
  return hn::Sub(hn::TableLookupLanes(corner, hn::SetTableIndices(Tag(), kNext)), corner);
}

/// Returns the gap between the projections along e_i x f, negative where they overlap; `half_m` is
/// half of component i of the normal.
HWY_INLINE Lanes gap(Lanes f_j, Lanes f_k, Lanes v_j, Lanes v_k, Lanes h_j, Lanes h_k,
                     Lanes half_m) {
  const Lanes middle = hn::Sub(hn::Sub(hn::Mul(f_k, v_j), hn::Mul(f_j, v_k)), half_m);
  const Lanes radius = hn::Add(hn::Mul(h_j, hn::Abs(f_k)), hn::Mul(h_k, hn::Abs(f_j)));
  return hn::Sub(hn::Abs(middle), hn::Add(hn::Abs(half_m), radius));
}

/// Returns a component of the cross product of the first two edges, in all lanes.
HWY_INLINE Lanes normal_component(Lanes f_j, Lanes f_k) {
  const Lanes lanes = hn::Sub(hn::Mul(f_j, hn::Shuffle01(f_k)), hn::Mul(f_k, hn::Shuffle01(f_j)));
  return hn::Set(Tag(), hn::GetLane(lanes));
}

struct Interval {
  Lanes centre, half;
};

HWY_INLINE Interval interval(double low, double high) {
  const Tag tag;
  return {hn::Set(tag, 0.5 * (low + high)), hn::Set(tag, 0.5 * (high - low))};
}

Verdict triage_remaining_axes(const double* t, const double* low, const double* high, double size) {
  const Tag tag;
  const Corners corner = corners(t);
  const Interval x = interval(low[0], high[0]);
  const Interval y = interval(low[1], high[1]);
  const Interval z = interval(low[2], high[2]);
  const Lanes f_x = edges(corner.x), f_y = edges(corner.y), f_z = edges(corner.z);
  const Lanes v_x = hn::Sub(corner.x, x.centre);
  const Lanes v_y = hn::Sub(corner.y, y.centre);
  const Lanes v_z = hn::Sub(corner.z, z.centre);
  const double f =
      hn::GetLane(hn::MaxOfLanes(tag, hn::Max(hn::Max(hn::Abs(f_x), hn::Abs(f_y)), hn::Abs(f_z))));
  if (!(f >= kSmallestBoxSize && size >= kSmallestBoxSize && size <= kLargestBoxSize)) {
    return Verdict::Unsure;
  }
  const Lanes n_x = normal_component(f_y, f_z);
  const Lanes n_y = normal_component(f_z, f_x);
  const Lanes n_z = normal_component(f_x, f_y);
  const Lanes distance = hn::Add(hn::Add(hn::Mul(n_x, v_x), hn::Mul(n_y, v_y)), hn::Mul(n_z, v_z));
  const Lanes radius =
      hn::Add(hn::Add(hn::Mul(x.half, hn::Abs(n_x)), hn::Mul(y.half, hn::Abs(n_y))),
              hn::Mul(z.half, hn::Abs(n_z)));
  const double normal_gap = hn::GetLane(hn::Sub(hn::Abs(distance), radius));
  const double normal_bound = kNormalBound * f * f * size;
  const Lanes half = hn::Set(tag, 0.5);
  const Lanes gap_x = gap(f_y, f_z, v_y, v_z, y.half, z.half, hn::Mul(half, n_x));
  const Lanes gap_y = gap(f_z, f_x, v_z, v_x, z.half, x.half, hn::Mul(half, n_y));
  const Lanes gap_z = gap(f_x, f_y, v_x, v_y, x.half, y.half, hn::Mul(half, n_z));
  const Lanes edge_gap = hn::Max(hn::Max(gap_x, gap_y), gap_z);
  const Lanes edge_bound = hn::Set(tag, kEdgeBound * f * size);
  const bool is_apart =
      !hn::AllFalse(tag, hn::Gt(edge_gap, edge_bound)) | (normal_gap > normal_bound);
  const bool is_touching =
      hn::AllTrue(tag, hn::Lt(edge_gap, hn::Neg(edge_bound))) & (normal_gap < -normal_bound);
  return verdict_of(is_apart, is_touching);
}

#else

/// Returns the gap between the projections along e_i x f, negative where they overlap; `half_m` is
/// half of component i of the normal.
TwoLanes gap(TwoLanes f_j, TwoLanes f_k, TwoLanes v_j, TwoLanes v_k, TwoLanes h_j, TwoLanes h_k,
             TwoLanes half_m) {
  const TwoLanes middle = (f_k * v_j - f_j * v_k) - half_m;
  const TwoLanes radius = h_j * magnitude(f_k) + h_k * magnitude(f_j);
  return magnitude(middle) - (magnitude(half_m) + radius);
}

/// Returns component i of the cross product of the two lanes' vectors, in both lanes.
TwoLanes cross_of_lanes(TwoLanes f_j, TwoLanes f_k) {
  const TwoLanes products = f_j * swapped(f_k);
  return both(products[0] - products[1]);
}

double larger_lane(TwoLanes v) {
  return std::max(v[0], v[1]);
}

TwoLanes largest(TwoLanes x, TwoLanes y, TwoLanes z) {
  return larger(larger(magnitude(x), magnitude(y)), magnitude(z));
}

/// Asks the remaining axes, for valid input of this sum of sizes.
Verdict triage_remaining_axes(const double* t, const double* low, const double* high, double size) {
  const TwoLanes centre_xy = 0.5 * (load(low) + load(high));
  const TwoLanes half_xy = 0.5 * (load(high) - load(low));
  const double centre_z = 0.5 * (low[2] + high[2]);
  const double half_z = 0.5 * (high[2] - low[2]);
  const TwoLanes h_x = both(half_xy[0]), h_y = both(half_xy[1]), h_z = both(half_z);
  // Lane 0 is the edge from a to b with its vertex a, lane 1 that from b to c with b.
  const TwoLanes a_x{t[0], t[3]}, a_y{t[1], t[4]}, a_z{t[2], t[5]};
  const TwoLanes f_x = TwoLanes{t[3], t[6]} - a_x;
  const TwoLanes f_y = TwoLanes{t[4], t[7]} - a_y;
  const TwoLanes f_z = TwoLanes{t[5], t[8]} - a_z;
  const TwoLanes v_x = a_x - both(centre_xy[0]);
  const TwoLanes v_y = a_y - both(centre_xy[1]);
  const TwoLanes v_z = a_z - both(centre_z);
  // The third edge is that from c to a, with c.
  const TwoLanes g_xy = load(t) - load(t + 6);
  const TwoLanes w_xy = load(t + 6) - centre_xy;
  const double g_z = t[2] - t[8];
  const double w_z = t[8] - centre_z;

  const double f =
      larger_lane(larger(larger(largest(f_x, f_y, f_z), magnitude(g_xy)), magnitude(both(g_z))));
  if (!(f >= kSmallestBoxSize && size >= kSmallestBoxSize && size <= kLargestBoxSize)) {
    return Verdict::Unsure;
  }
  const double edge_bound = kEdgeBound * f * size;
  const double normal_bound = kNormalBound * f * f * size;

  const TwoLanes n_x = cross_of_lanes(f_y, f_z);
  const TwoLanes n_y = cross_of_lanes(f_z, f_x);
  const TwoLanes n_z = cross_of_lanes(f_x, f_y);
  const double distance = n_x[0] * v_x[0] + n_y[0] * v_y[0] + n_z[0] * v_z[0];
  const double radius =
      h_x[0] * std::abs(n_x[0]) + h_y[0] * std::abs(n_y[0]) + h_z[0] * std::abs(n_z[0]);
  const double normal_gap = std::abs(distance) - radius;

  TwoLanes gaps = gap(f_y, f_z, v_y, v_z, h_y, h_z, 0.5 * n_x);
  gaps = larger(gaps, gap(f_z, f_x, v_z, v_x, h_z, h_x, 0.5 * n_y));
  gaps = larger(gaps, gap(f_x, f_y, v_x, v_y, h_x, h_y, 0.5 * n_z));
  // Axes x and y of the third edge are asked together; z is asked twice.
  const TwoLanes g_yz{g_xy[1], g_z}, g_zx{g_z, g_xy[0]};
  const TwoLanes w_yz{w_xy[1], w_z}, w_zx{w_z, w_xy[0]};
  const TwoLanes h_yz{half_xy[1], half_z}, h_zx{half_z, half_xy[0]};
  gaps =
      larger(gaps, gap(g_yz, g_zx, w_yz, w_zx, h_yz, h_zx, TwoLanes{0.5 * n_x[0], 0.5 * n_y[0]}));
  gaps = larger(
      gaps, gap(both(g_xy[0]), both(g_xy[1]), both(w_xy[0]), both(w_xy[1]), h_x, h_y, 0.5 * n_z));
  const double edge_gap = larger_lane(gaps);
  const bool is_apart = (edge_gap > edge_bound) | (normal_gap > normal_bound);
  const bool is_touching = (edge_gap < -edge_bound) & (normal_gap < -normal_bound);
  return verdict_of(is_apart, is_touching);
}

#endif

}  // namespace
}  // namespace graze::narrowphase::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graze::narrowphase {

HWY_EXPORT(triage_remaining_axes);

Verdict triage_remaining_axes(const double* t, const double* low, const double* high, double size) {
  return HWY_DYNAMIC_DISPATCH(triage_remaining_axes)(t, low, high, size);
}

}  // namespace graze::narrowphase
#endif
