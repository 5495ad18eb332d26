// The margin, u = 2^-53, in units in which all placed coordinates are below 1. With the derivation
// of law 5's slack (relative_frame.cpp): a placed vertex is P + R (x - o) + e, |e| <= 2 placing =
// 16 u (m + |t|); m is below 1.74 of the largest placed coordinate and |t| below it: 44 u for both
// meshes. R is taken as it is. Products R_k . n are off by 3 u of the size of n; with local
// coordinates, up to 2, of three axes, in units of at most 1.74: 32 u. A box is its middle and its
// half along n, and no term of the sums of both boxes passes more than eight roundings; the sums
// are below 8 of the size of n: 64 u. With the 16 u of law 1's rounding of a moved B these are 156
// u.

#include <graze/bvh/value/dot.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/sweep/swept_nodes.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::contacts {
namespace {

constexpr double kNodeMargin = 160 * kUnitRoundoff;

using bvh::dot;

double half_size(const bvh::FloatBox& box) {
  double size = 0;
  for (int k = 0; k < 3; ++k)
    size += double{box.max[k]} - box.min[k];
  return size;
}

}  // namespace

SweptNodes::Frame::Frame(const PlacedMeshView& placed, const SweepUnits& units) {
  const bvh::LocalFrame& frame = tree_of(placed.mesh).frame;
  const Eigen::Vector3d origin = narrowphase::place(
      placed.pose, Eigen::Vector3d(frame.centre[0], frame.centre[1], frame.centre[2]));
  for (int k = 0; k < 3; ++k) {
    centre[k] = origin.data()[k] * units.per_metre;
    for (int i = 0; i < 3; ++i)
      axis[k][i] = placed.pose.data()[4 * k + i];
  }
  unit = frame.unit() * units.per_metre;
}

void SweptNodes::add(const double (&n)[3], const double (&d)[3], const Frame& a, const Frame& b) {
  const double size = std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]);
  if (!says_something(size)) return;
  const double sense = dot(n, d) < 0 ? -1 : 1;
  const double between[3] = {a.centre[0] - b.centre[0], a.centre[1] - b.centre[1],
                             a.centre[2] - b.centre[2]};
  const SweepScale scale(sense * dot(n, d), size);
  directions_[count_] = {sense * dot(n, between), kNodeMargin * size, scale.across, scale.up,
                         scale.down};
  for (int k = 0; k < 3; ++k) {
    scale_a_[count_][k] = sense * (dot(n, a.axis[k]) * a.unit);
    scale_b_[count_][k] = sense * (dot(n, b.axis[k]) * b.unit);
  }
  ++count_;
}

SweptNodes::SweptNodes(const PlacedMeshView& a, const PlacedMeshView& b, const SweepUnits& units,
                       const double (&d)[3]) {
  const Frame frame_a(a, units);
  const Frame frame_b(b, units);
  unit_a_ = frame_a.unit;
  unit_b_ = frame_b.unit;
  add(d, d, frame_a, frame_b);
  for (const Frame* frame : {&frame_a, &frame_b}) {
    for (const double(&e)[3] : frame->axis) {
      const double across[3] = {e[1] * d[2] - e[2] * d[1], e[2] * d[0] - e[0] * d[2],
                                e[0] * d[1] - e[1] * d[0]};
      add(across, d, frame_a, frame_b);
      add(e, d, frame_a, frame_b);
    }
  }
}

SweptNodes::Extent SweptNodes::extent(const bvh::FloatBox& box,
                                      const std::array<Scale, kDirections>& scale) const {
  double middle[3];
  double half[3];
  for (int k = 0; k < 3; ++k) {
    middle[k] = 0.5 * (double{box.max[k]} + box.min[k]);
    half[k] = 0.5 * (double{box.max[k]} - box.min[k]);
  }
  Extent extent;
  for (std::size_t i = 0; i < count_; ++i) {
    const Scale& n = scale[i];
    extent.middle[i] = (n[0] * middle[0] + n[1] * middle[1]) + n[2] * middle[2];
    extent.half[i] =
        (std::abs(n[0]) * half[0] + std::abs(n[1]) * half[1]) + std::abs(n[2]) * half[2];
  }
  return extent;
}

double SweptNodes::last_contact(const Extent& a, const Extent& b, double enough) const {
  double lower = 0;
  double upper = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count_; ++i) {
    const Direction& n = directions_[i];
    const double middle = (a.middle[i] - b.middle[i]) + n.between;
    const double half = (a.half[i] + b.half[i]) + n.margin;
    const double low = middle - half;
    const double high = middle + half;
    if (n.across >= 0) {
      if (high < -n.across || low > n.across) return -1;
      continue;
    }
    if (high < 0) return -1;
    upper = std::min(upper, high * n.up);
    lower = std::max(lower, low * n.down);
    if (lower > upper) return -1;
    if (upper <= enough) return upper;
  }
  return upper;
}

double SweptNodes::size_a(const bvh::FloatBox& box) const {
  return half_size(box) * unit_a_;
}
double SweptNodes::size_b(const bvh::FloatBox& box) const {
  return half_size(box) * unit_b_;
}

}  // namespace graze::contacts
