// Akenine-Möller's test in rounded arithmetic, two axes at a time. The box axes, and a vertex
// inside the box, are decided by comparing inputs, exactly; the other ten axes by one error bound
// each kind (box_bound.h).

#include <graze/narrowphase/box_bound.h>
#include <graze/narrowphase/coordinates.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/two_lanes.h>
#include <graze/narrowphase/verdicts.h>
#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::narrowphase {
namespace {

TwoLanes load(const double* p) {
  return TwoLanes{p[0], p[1]};
}

/// The sum of the absolute values of all coordinates: infinite or NaN as soon as one of them is.
double sum_of_sizes(const double* t, const double* low, const double* high) {
  const TwoLanes sum = ((magnitude(load(t)) + magnitude(load(t + 2))) +
                        (magnitude(load(t + 4)) + magnitude(load(t + 6)))) +
                       (magnitude(load(low)) + magnitude(load(high))) +
                       magnitude(TwoLanes{low[2], high[2]});
  return sum[0] + sum[1] + std::abs(t[8]);
}

bool is_ordered(const double* low, const double* high) {
  return (sign_bits(are_greater(load(low), load(high))) == 0) & (low[2] <= high[2]);
}

/// Without branches: what random input does here cannot be foreseen.
bool is_apart_along_box_axes(const double* t, const double* low, const double* high) {
  const TwoLanes a = load(t), b = load(t + 3), c = load(t + 6);
  const TwoLanes above = are_greater(smaller(smaller(a, b), c), load(high));
  const TwoLanes below = are_greater(load(low), larger(larger(a, b), c));
  const double lowest = std::min(std::min(t[2], t[5]), t[8]);
  const double highest = std::max(std::max(t[2], t[5]), t[8]);
  const TwoLanes along_z = are_greater(TwoLanes{lowest, low[2]}, TwoLanes{high[2], highest});
  return sign_bits(either_of(either_of(above, below), along_z)) != 0;
}

bool contains(const double* low, const double* high, const double* point) {
  bool is_inside = true;
  for (int k = 0; k < 3; ++k)
    is_inside &= low[k] <= point[k] && point[k] <= high[k];
  return is_inside;
}

/// The gap between the projections along e_i x f, negative where they overlap; `half_m` is half of
/// component i of the normal.
TwoLanes gap(TwoLanes f_j, TwoLanes f_k, TwoLanes v_j, TwoLanes v_k, TwoLanes h_j, TwoLanes h_k,
             TwoLanes half_m) {
  const TwoLanes middle = (f_k * v_j - f_j * v_k) - half_m;
  const TwoLanes radius = h_j * magnitude(f_k) + h_k * magnitude(f_j);
  return magnitude(middle) - (magnitude(half_m) + radius);
}

/// Component i of the cross product of the two lanes' vectors, in both lanes.
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

/// The ten axes, for valid input of this sum of sizes.
Verdict triage_ten_axes(const double* t, const double* low, const double* high, double size) {
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
  // The edge from c to a with c.
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
  // Axes x and y of the third edge together; z twice.
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

}  // namespace

Verdict triage(const Triangle& triangle, const Aabb& box) {
  const double* t = coordinates(triangle);
  const double* low = box.min.data();
  const double* high = box.max.data();
  const double size = sum_of_sizes(t, low, high);
  if (!(size <= std::numeric_limits<double>::max()) || !is_ordered(low, high)) {
    return Verdict::Unsure;
  }
  if (is_apart_along_box_axes(t, low, high)) return Verdict::Apart;
  const Verdict verdict = triage_ten_axes(t, low, high, size);
  if (verdict != Verdict::Unsure) return verdict;
  const bool is_inside =
      contains(low, high, t) || contains(low, high, t + 3) || contains(low, high, t + 6);
  return is_inside ? Verdict::Touching : Verdict::Unsure;
}

}  // namespace graze::narrowphase
