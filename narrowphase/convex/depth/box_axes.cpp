#include <graze/bvh/pose.h>
#include <graze/narrowphase/convex/core/segments.h>
#include <graze/narrowphase/convex/depth/box_axes.h>

#include <algorithm>
#include <initializer_list>
#include <limits>

namespace graze::narrowphase {
namespace {

// Edges at a smaller angle than about this give no axis of their own: faces do as well there.
constexpr double kParallel = 1e-6;
constexpr double kEdgeGain = 0.95;

// A test along the axes must be sure by this share of the offset between the middles and of all
// half extents. verdict() stands for may_overlap(), whose slack (../volumes/obb_slack.h) is below
// 18 dev of the half extents and which takes either box's frame, dev being kMaxRotationDeviation.
// Projected radii are the same there but for the order of sums. An offset along an axis of B it
// takes from A's frame: off by 3.1 dev of the offset between the middles. An offset along a product
// it takes in either frame, in each by the frame's determinant, off from 1 by 4.5 dev, and with
// unit vectors for the frame's own axes, off by 1.8 dev: by 12.6 dev in all. The offset is at most
// the sum of its coordinates and dev of that. Rounding is nothing beside.
constexpr double kSure = 32 * kMaxRotationDeviation;

}  // namespace

// The 15 axes as bvh/value/separating_axes.h derives them. The sums are this class's own, because
// they are rounded in another order, and the last bit decides which of two equal axes gives the
// normal of a contact. Axes are at right angles and of length 1 as far as poses are rotations: near
// enough to compare by.
BoxAxes::BoxAxes(const Core& box_a, const Core& box_b) : box_a_(box_a), box_b_(box_b) {
  const double half_a[3] = {box_a.half.x, box_a.half.y, box_a.half.z};
  const double half_b[3] = {box_b.half.x, box_b.half.y, box_b.half.z};
  double turn[3][3], size[3][3];  // of B's axes in A's frame
  const Vec3 between = box_b.at - box_a.at;
  for (int i = 0; i < 3; ++i) {
    offset_a_[i] = dot(box_a.axis[i], between);
    offset_b_[i] = dot(box_b.axis[i], between);
    for (int j = 0; j < 3; ++j) {
      turn[i][j] = dot(box_a.axis[i], box_b.axis[j]);
      size[i][j] = std::abs(turn[i][j]);
    }
  }
  for (int i = 0; i < 3; ++i) {
    overlap_a_[i] = half_a[i] +
                    ((half_b[0] * size[i][0] + half_b[1] * size[i][1]) + half_b[2] * size[i][2]) -
                    std::abs(offset_a_[i]);
    overlap_b_[i] = half_b[i] +
                    ((half_a[0] * size[0][i] + half_a[1] * size[1][i]) + half_a[2] * size[2][i]) -
                    std::abs(offset_b_[i]);
  }
  constexpr int kNext[3] = {1, 2, 0};
  for (int i = 0; i < 3; ++i) {
    const int i1 = kNext[i], i2 = kNext[i1];
    for (int j = 0; j < 3; ++j) {
      const int j1 = kNext[j], j2 = kNext[j1];
      const double u = turn[i1][j], v = turn[i2][j];
      square_[i][j] = u * u + v * v;
      offset_[i][j] = u * offset_a_[i2] - v * offset_a_[i1];
      overlap_[i][j] = (half_a[i1] * size[i2][j] + half_a[i2] * size[i1][j]) +
                       (half_b[j1] * size[i][j2] + half_b[j2] * size[i][j1]) -
                       std::abs(offset_[i][j]);
    }
  }
  const double offset = (std::abs(offset_a_[0]) + std::abs(offset_a_[1])) + std::abs(offset_a_[2]);
  const double sizes =
      ((half_a[0] + half_a[1]) + half_a[2]) + ((half_b[0] + half_b[1]) + half_b[2]);
  margin_ = kSure * (offset + sizes);
}

Verdict BoxAxes::verdict() const {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    least = std::min(least, std::min(overlap_a_[i], overlap_b_[i]));
    for (int j = 0; j < 3; ++j)
      least = std::min(least, overlap_[i][j]);
  }
  if (least < -margin_) return Verdict::No;
  return least > margin_ ? Verdict::Yes : Verdict::Unsure;
}

// If two boxes are apart along the product n of two edges with an angle phi between them, turning
// one by phi about n makes these parallel, and n parts them still. Then, seen along the edges, they
// are rectangles, which an axis of a face parts. Turning it back moves points along that axis by no
// more than phi times the offset between the middles and all half extents: the faces overlap by no
// more.
bool BoxAxes::may_hide_gap(double sine) const {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
    least = std::min(least, std::min(overlap_a_[i], overlap_b_[i]));
  const double unsure = 2 * (margin_ / kSure);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (square_[i][j] >= sine * sine) continue;
      if (!(least > unsure * std::sqrt(square_[i][j]))) return true;
    }
  }
  return false;
}

Penetration BoxAxes::least_penetration() const {
  Vec3 best;
  double depth = std::numeric_limits<double>::infinity();
  const auto offer_face = [&](double found, const Vec3& axis, double offset) {
    if (!(found < depth)) return;
    depth = found;
    best = offset < 0 ? -axis : axis;
  };
  for (int i = 0; i < 3; ++i)
    offer_face(overlap_a_[i], box_a_.axis[i], offset_a_[i]);
  for (int j = 0; j < 3; ++j)
    offer_face(overlap_b_[j], box_b_.axis[j], offset_b_[j]);
  int edge_a = -1, edge_b = -1;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double square = square_[i][j];
      if (!(square > kParallel * kParallel)) continue;
      const double found = overlap_[i][j];
      const double wanted = kEdgeGain * depth;
      if (found > 0 && wanted > 0 && found * found >= (wanted * wanted) * square) continue;
      const double of_unit = found / std::sqrt(square);
      if (!(of_unit < wanted)) continue;
      depth = of_unit;
      edge_a = i, edge_b = j;
    }
  }
  if (edge_a >= 0) {
    const Vec3 product = cross(box_a_.axis[edge_a], box_b_.axis[edge_b]);
    best = offset_[edge_a][edge_b] < 0 ? -product : product;
  }
  best = unit_or(best, {0, 0, 1});
  Penetration penetration = along(box_a_, box_b_, best);
  if (edge_a < 0) return penetration;
  const BoxEdge of_a = edge_along(box_a_, edge_a, best);
  const BoxEdge of_b = edge_along(box_b_, edge_b, -best);
  const NearestPoints met = nearest_of_segments(of_a.from, of_a.to, of_b.from, of_b.to);
  penetration.point_a = met.point_a;
  penetration.point_b = met.point_b;
  penetration.has_witnesses = true;
  return penetration;
}

BoxEdge edge_along(const Core& box, int axis, const Vec3& direction) {
  const double half[3] = {box.half.x, box.half.y, box.half.z};
  Vec3 middle = box.at;
  for (int k = 0; k < 3; ++k) {
    if (k == axis) continue;
    middle = middle + box.axis[k] * (dot(box.axis[k], direction) < 0 ? -half[k] : half[k]);
  }
  const Vec3 half_edge = box.axis[axis] * half[axis];
  return {middle - half_edge, middle + half_edge};
}

Penetration nearest_face(const Core& box, const Core& point) {
  Penetration best{};
  bool is_first = true;
  for (const Vec3& axis : box.axis) {
    for (const double sign : {1.0, -1.0}) {
      const Penetration found = along(box, point, unit_or(axis * sign, {0, 0, 1}));
      if (is_first || found.depth < best.depth) best = found;
      is_first = false;
    }
  }
  return best;
}

}  // namespace graze::narrowphase
