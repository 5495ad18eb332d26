// The margin, u = 2^-53, in units in which all placed coordinates are below 1. With the derivation
// of law 5's slack (relative_frame.cpp): a placed vertex is P + R (x - o) + e, |e| <= 2 placing =
// 16 u (m + |t|); m is below 1.74 of the placed reach and |t| below it: 44 u for both meshes. R is
// taken as it is. Products R_k . n are off by 3 u of the size of n; with local coordinates, up to
// 2, of three axes, in units of at most 1.74: 32 u. The sum of seven terms, together below 8 of the
// size of n, by 56 u. With the 16 u of law 1's rounding of a moved B these are 148 u.

#include <graze/engine/mesh/contacts/swept_nodes.h>
#include <graze/engine/mesh/placement.h>

#include <algorithm>
#include <cmath>

namespace graze::contacts {
namespace {

constexpr double kMargin = 160 * kUnitRoundoff;

double dot(const double* a, const double* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double half_size(const bvh::FloatBox& box) {
  double size = 0;
  for (int k = 0; k < 3; ++k)
    size += double{box.max[k]} - box.min[k];
  return size;
}

}  // namespace

SweptNodes::Frame::Frame(const PlacedMesh& placed, const SweepUnits& units) {
  const bvh::LocalFrame& frame = placed.mesh.tree().frame;
  const Eigen::Vector3d origin =
      place(placed.pose, Eigen::Vector3d(frame.centre[0], frame.centre[1], frame.centre[2]));
  for (int k = 0; k < 3; ++k) {
    centre[k] = origin.data()[k] * units.per_metre;
    for (int i = 0; i < 3; ++i)
      axis[k][i] = placed.pose.data()[4 * k + i];
  }
  unit = frame.unit() * units.per_metre;
}

SweptNodes::Direction SweptNodes::direction_of(const double* n, const double* d, const Frame& a,
                                               const Frame& b) {
  const double between[3] = {a.centre[0] - b.centre[0], a.centre[1] - b.centre[1],
                             a.centre[2] - b.centre[2]};
  Direction direction{
      dot(n, d), std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]), dot(n, between), {}, {}};
  for (int k = 0; k < 3; ++k) {
    direction.scale_a[k] = dot(n, a.axis[k]) * a.unit;
    direction.scale_b[k] = dot(n, b.axis[k]) * b.unit;
  }
  return direction;
}

SweptNodes::SweptNodes(const PlacedMesh& a, const PlacedMesh& b, const SweepUnits& units,
                       const double (&d)[3]) {
  const Frame frame_a(a, units);
  const Frame frame_b(b, units);
  unit_a_ = frame_a.unit;
  unit_b_ = frame_b.unit;
  std::size_t count = 0;
  const auto add = [&](double x, double y, double z) {
    const double n[3] = {x, y, z};
    directions_[count++] = direction_of(n, d, frame_a, frame_b);
  };
  add(d[0], d[1], d[2]);
  for (const Frame* frame : {&frame_a, &frame_b}) {
    for (const double(&e)[3] : frame->axis) {
      add(e[1] * d[2] - e[2] * d[1], e[2] * d[0] - e[0] * d[2], e[0] * d[1] - e[1] * d[0]);
      add(e[0], e[1], e[2]);
    }
  }
}

double SweptNodes::last_contact(const bvh::FloatBox& a, const bvh::FloatBox& b,
                                double enough) const {
  SweepBounds bounds(kMargin);
  for (const Direction& n : directions_) {
    double lowest = n.between;
    double highest = n.between;
    for (int k = 0; k < 3; ++k) {
      const double a0 = n.scale_a[k] * a.min[k];
      const double a1 = n.scale_a[k] * a.max[k];
      const double b0 = n.scale_b[k] * b.min[k];
      const double b1 = n.scale_b[k] * b.max[k];
      lowest += std::min(a0, a1) - std::max(b0, b1);
      highest += std::max(a0, a1) - std::min(b0, b1);
    }
    bounds.note(n.along, n.size, lowest, highest);
    if (bounds.is_empty()) return -1;
    if (bounds.upper() <= enough) break;
  }
  return bounds.upper();
}

bool SweptNodes::is_first_larger(const bvh::FloatBox& a, const bvh::FloatBox& b) const {
  return half_size(a) * unit_a_ >= half_size(b) * unit_b_;
}

}  // namespace graze::contacts
