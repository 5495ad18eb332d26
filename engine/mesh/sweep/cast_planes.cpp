// The margin, u = 2^-53, in units in which all placed coordinates are below 1: that of boxes is
// derived in swept_nodes.cpp, of which what law 1 rounds of a moved B, 16 u, is not needed: here B
// moves in real arithmetic; 140 u. A k-DOP ends along a vector where three of its slabs say. Each
// of their weights is off by 2 u of the vector's largest component in the tree's frame; with slabs
// up to 4, of both meshes together in units of at most 1.74, that is 42 u more. The sums are those
// of boxes: twice the sum of the components' sizes, of each mesh. Corners of triangles are where
// they are placed. One of them relative to a centre is below 2, off by 2 u; its product with n by 8
// u of the size of n with that: 10 u. The sums of both triangles with 4 u of what is between the
// centres go through three roundings of 4, 6 and 9: below 50 u, less than for k-DOPs. The normal of
// a triangle's plane is a vector like these, and less is rounded along it.

#include <graze/bvh/tree/tree.h>
#include <graze/bvh/value/dot.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/sweep/cast_planes.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::contacts {
namespace {

constexpr double kMargin = 192 * kUnitRoundoff;

// In the frame of a box what law 1 rounds of a mesh, 44 u in each coordinate, is up to 1.74 times
// as much; law 3 rounds 1 u of a difference, times 1.74, and 4 u in products and sums, of a vertex
// and of the tree's centre; an axis of the mesh in that frame is off by 3 u, which is 31 u in its
// products with n and local coordinates: 245 u in all.
constexpr double kFramedMargin = 256 * kUnitRoundoff;

using bvh::dot;

}  // namespace

CastPlanes::Frame::Frame(const FramedMesh& mesh, const SweepUnits& units)
    : margin(mesh.frame != nullptr ? kFramedMargin : kMargin) {
  const bvh::LocalFrame& frame = tree_of(mesh.placed.mesh).frame;
  const Eigen::Vector3d origin = mesh.point({frame.centre[0], frame.centre[1], frame.centre[2]});
  const double* m = mesh.placed.pose.data();
  for (int k = 0; k < 3; ++k) {
    centre[k] = origin.data()[k] * units.per_metre;
    for (int i = 0; i < 3; ++i)
      axis[k][i] =
          mesh.frame != nullptr ? dot(mesh.frame->data() + 4 * i, m + 4 * k) : m[4 * k + i];
  }
  unit = frame.unit() * units.per_metre;
}

/// Makes the frame of a box, of which only the corners are asked for.
CastPlanes::Frame::Frame(const Aabb& box, const SweepUnits& units)
    : axis{}, unit(0), margin(kMargin) {
  for (int k = 0; k < 3; ++k) {
    const double low = box.min.data()[k] * units.per_metre;
    const double high = box.max.data()[k] * units.per_metre;
    centre[k] = 0.5 * (low + high);
  }
}

CastPlanes::Frame::Frame(const Sphere& ball, const SweepUnits& units)
    : axis{}, unit(0), margin(kMargin) {
  for (int k = 0; k < 3; ++k)
    centre[k] = ball.centre.data()[k] * units.per_metre;
}

CastPlanes::CastPlanes(const Frame& a, const Frame& b, const SweepUnits& units,
                       const double (&direction)[3])
    : per_metre_(units.per_metre), a_(a), b_(b) {
  std::copy(direction, direction + 3, direction_);
}

/// Returns the limit of a vector. One of size 0 says nothing: nothing is beside it, and all is from
/// 0 on.
CastPlanes::Limit CastPlanes::limit_of(const double (&n)[3]) const {
  const double size = std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]);
  if (!says_something(size)) return {0, 0, 0, 0, kInfinity, 0};
  const double along = dot(n, direction_);
  const double sense = along < 0 ? -1 : 1;
  const double between[3] = {a_.centre[0] - b_.centre[0], a_.centre[1] - b_.centre[1],
                             a_.centre[2] - b_.centre[2]};
  const SweepScale scale(sense * along, size);
  const double across = 2 * scale.across;  // |d| is at least 1/2
  const bool is_across = across >= 0;
  return {sense,
          sense * dot(n, between),
          a_.margin * size,
          is_across ? -across : 0,
          is_across ? across : kInfinity,
          is_across ? 0 : scale.down};
}

void CastPlanes::measure_along(Side side, const double (&n)[3], const Triangle& placed, double& low,
                               double& high) const {
  const double* centre = frame(side).centre;
  const double* corners[3] = {placed.a.data(), placed.b.data(), placed.c.data()};
  double value[3];
  for (int i = 0; i < 3; ++i) {
    const double p[3] = {corners[i][0] * per_metre_ - centre[0],
                         corners[i][1] * per_metre_ - centre[1],
                         corners[i][2] * per_metre_ - centre[2]};
    value[i] = dot(n, p);
  }
  low = std::min(value[0], std::min(value[1], value[2]));
  high = std::max(value[0], std::max(value[1], value[2]));
}

/// Returns the plane of a triangle. Its normal is whatever rounding makes of it: the bounds hold
/// for any vector.
CastPlanes::Plane CastPlanes::plane_of(Side side, const Triangle& placed) const {
  double edge[2][3];
  for (int k = 0; k < 3; ++k) {
    const double from = placed.a.data()[k] * per_metre_;
    edge[0][k] = placed.b.data()[k] * per_metre_ - from;
    edge[1][k] = placed.c.data()[k] * per_metre_ - from;
  }
  double normal[3];
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    normal[k] = edge[0][i] * edge[1][j] - edge[0][j] * edge[1][i];
  }
  Plane plane;
  plane.limit = limit_of(normal);
  for (int k = 0; k < 3; ++k)
    plane.n[k] = plane.limit.sense * normal[k];
  measure_along(side, plane.n, placed, plane.low, plane.high);
  return plane;
}

double CastPlanes::first_contact(Side side, const Plane& plane, const Triangle& other,
                                 double limit) const {
  double low, high;
  measure_along(side == Side::A ? Side::B : Side::A, plane.n, other, low, high);
  const bool is_of_a = side == Side::A;
  const Limit& of_n = plane.limit;
  const double least =
      ((is_of_a ? plane.low - high : low - plane.high) + of_n.between) - of_n.margin;
  const double most =
      ((is_of_a ? plane.high - low : high - plane.low) + of_n.between) + of_n.margin;
  if (most < of_n.least_high || least > of_n.most_low) return kInfinity;
  const double bound = std::max(0.0, least * of_n.down);
  return bound > limit ? kInfinity : bound;
}

}  // namespace graze::contacts
