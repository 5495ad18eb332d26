#include <graze/bvh/skins/kdop_separation.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {
namespace {

// The slack of RelativeFrame is twice the error in one coordinate of either frame and serves axes
// with 1-norms below 1.74. The directions (1, 1, 0) have 1-norms of 2 in their own frame and up to
// sqrt(3) sqrt(2) = 2.45 in the other.
constexpr double kSlackFactor = 1.5;

// The slabs of e_i + e_j and of e_i - e_j stand at 2 + i + j and 5 + i + j, that of e_i at i.
constexpr bool are_slabs_where_expected() {
  for (int i = 0; i < 3; ++i) {
    if (kKDopDirections<18>[i][i] != 1) return false;
    for (int j = i + 1; j < 3; ++j) {
      const auto& sum = kKDopDirections<18>[2 + i + j];
      const auto& difference = kKDopDirections<18>[5 + i + j];
      if (sum[i] != 1 || sum[j] != 1 || difference[i] != 1 || difference[j] != -1) return false;
    }
  }
  return true;
}
static_assert(are_slabs_where_expected());

void set_term(KDopCombination& combination, int term, int slab, double weight) {
  combination.slab[term] = slab;
  combination.along[term] = std::max(weight, 0.0);
  combination.against[term] = std::min(weight, 0.0);
}

/// Adds weight * (sign_i e_i + sign_j e_j).
void set_edge(KDopCombination& combination, int term, int i, int j, const int (&sign)[3],
              double weight) {
  const int low = std::min(i, j);
  const int high = std::max(i, j);
  const int slab = (sign[low] == sign[high] ? 2 : 5) + low + high;
  set_term(combination, term, slab, sign[low] * weight);
}

}  // namespace

// With components sorted by size, a >= b >= c >= 0: if a >= b + c, the direction is (a - b - c)
// (1, 0, 0) + b (1, 1, 0) + c (1, 0, 1), and otherwise half of (a + b - c) (1, 1, 0) + (a + c - b)
// (1, 0, 1) + (b + c - a) (0, 1, 1).
KDopCombination combination_of(const double (&direction)[3]) {
  int order[3] = {0, 1, 2};
  int sign[3];
  double size[3];
  for (int k = 0; k < 3; ++k) {
    size[k] = std::abs(direction[k]);
    sign[k] = direction[k] < 0 ? -1 : 1;
  }
  std::sort(order, order + 3, [&](int i, int j) { return size[i] > size[j]; });
  const int i = order[0], j = order[1], k = order[2];
  const double a = size[i], b = size[j], c = size[k];
  KDopCombination combination;
  if (a >= b + c) {
    set_term(combination, 0, i, sign[i] * (a - b - c));
    set_edge(combination, 1, i, j, sign, b);
    set_edge(combination, 2, i, k, sign, c);
  } else {
    set_edge(combination, 0, i, j, sign, 0.5 * (a + b - c));
    set_edge(combination, 1, i, k, sign, 0.5 * (a + c - b));
    set_edge(combination, 2, j, k, sign, 0.5 * (b + c - a));
  }
  return combination;
}

// A point b of B is at C b + T, so its coordinate along a direction L of A is (C^T L) . b + L . T.
// Along the direction C L of A's frame, for a direction L of B, it is L . b + (C L) . T but for the
// deviation of C from a rotation, which the slack covers, and a point a of A is at (C L) . a.
KDopSeparation::KDopSeparation(const RelativeFrame& frame, std::span<const FloatKDop> skin_a,
                               std::span<const FloatKDop> skin_b)
    : slack_(kSlackFactor * frame.slack), skin_a_(skin_a), skin_b_(skin_b) {
  const double(&c)[3][3] = frame.rotation;
  const double* t = frame.translation;
  view_a_.units_own = view_b_.units_other = frame.units_a;
  view_a_.units_other = view_b_.units_own = frame.units_b;
  for (int slab = 0; slab < kSlabs; ++slab) {
    const auto& d = kKDopDirections<18>[slab];
    double in_b[3], in_a[3];
    for (int k = 0; k < 3; ++k) {
      in_b[k] = d[0] * c[0][k] + d[1] * c[1][k] + d[2] * c[2][k];
      in_a[k] = c[k][0] * d[0] + c[k][1] * d[1] + c[k][2] * d[2];
    }
    view_a_.combinations[slab] = combination_of(in_b);
    view_a_.shift[slab] = d[0] * t[0] + d[1] * t[1] + d[2] * t[2];
    view_b_.combinations[slab] = combination_of(in_a);
    view_b_.shift[slab] = -(in_a[0] * t[0] + in_a[1] * t[1] + in_a[2] * t[2]);
  }
}

bool KDopSeparation::are_apart(std::uint32_t a, std::uint32_t b) const {
  return is_apart_in(view_a_, skin_a_[a], skin_b_[b]) ||
         is_apart_in(view_b_, skin_b_[b], skin_a_[a]);
}

bool KDopSeparation::is_apart_in(const View& view, const FloatKDop& own,
                                 const FloatKDop& other) const {
  for (int slab = 0; slab < kSlabs; ++slab) {
    const KDopCombination& combination = view.combinations[slab];
    double high = 0;
    double low = 0;
    for (int term = 0; term < 3; ++term) {
      const double min = other.min[combination.slab[term]];
      const double max = other.max[combination.slab[term]];
      high += combination.along[term] * max + combination.against[term] * min;
      low += combination.along[term] * min + combination.against[term] * max;
    }
    const double shift = view.shift[slab];
    if (shift + low * view.units_other > own.max[slab] * view.units_own + slack_) return true;
    if (shift + high * view.units_other < own.min[slab] * view.units_own - slack_) return true;
  }
  return false;
}

bool KDopSeparation::is_first_larger(std::uint32_t a, std::uint32_t b) const {
  float size_a = 0;
  float size_b = 0;
  for (int k = 0; k < 3; ++k) {
    size_a += skin_a_[a].max[k] - skin_a_[a].min[k];
    size_b += skin_b_[b].max[k] - skin_b_[b].min[k];
  }
  return size_a * view_a_.units_own >= size_b * view_a_.units_other;
}

}  // namespace graze::bvh
