// Makes Akenine-Möller's test in rounded arithmetic. The box axes, and a vertex inside the box, are
// decided here by comparing inputs, exactly; the remaining axes are decided in remaining_axes.cpp.

#include <graze/narrowphase/lanes/two_lanes.h>
#include <graze/narrowphase/lanes/verdicts.h>
#include <graze/narrowphase/predicates/coordinates.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/remaining_axes.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>
#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::narrowphase {
namespace {

/// Returns the sum of the absolute values of all coordinates: infinite or NaN as soon as one of
/// them is.
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

/// This has no branches, because a CPU cannot predict them for random input.
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

}  // namespace

Verdict triage(const Triangle& triangle, const Aabb& box) {
  const double* t = coordinates(triangle);
  const double* low = box.min.data();
  const double* high = box.max.data();
  const double size = sum_of_sizes(t, low, high);
  if (!(size <= std::numeric_limits<double>::max()) || !is_ordered(low, high)) {
    return Verdict::Unsure;
  }
  if (is_apart_along_box_axes(t, low, high)) return Verdict::No;
  const Verdict verdict = triage_remaining_axes(t, low, high, size);
  if (verdict != Verdict::Unsure) return verdict;
  const bool is_inside =
      contains(low, high, t) || contains(low, high, t + 3) || contains(low, high, t + 6);
  return is_inside ? Verdict::Yes : Verdict::Unsure;
}

}  // namespace graze::narrowphase
