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
#include <graze/engine/mesh/sweep/cast_directions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::contacts {
namespace {

using narrowphase::both;
using narrowphase::larger;
using narrowphase::smaller;
using narrowphase::TwoLanes;

constexpr double kMargin = 192 * kUnitRoundoff;

// In the frame of a box what law 1 rounds of a mesh, 44 u in each coordinate, is up to 1.74 times
// as much; law 3 rounds 1 u of a difference, times 1.74, and 4 u in products and sums, of a vertex
// and of the tree's centre; an axis of the mesh in that frame is off by 3 u, which is 31 u in its
// products with n and local coordinates: 245 u in all.
constexpr double kFramedMargin = 256 * kUnitRoundoff;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr int kSlabs = KDop<18>::kSlabs;

// What lies beyond margins across d, by whatever, times that is beyond any limit; or so little
// beyond that it need not be told.
constexpr double kSurelyLate = 0x1p1000;

// Of two unit vectors: 4 degrees.
constexpr double kNearlyAlike = 0.9976;

using bvh::dot;

struct Vector {
  double at[3];
};

Vector cross(const double* a, const double* b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

Vector sum(const Vector& v, const Vector& w, double factor) {
  return {{v.at[0] + factor * w.at[0], v.at[1] + factor * w.at[1], v.at[2] + factor * w.at[2]}};
}

/// With length 1, or what it was if that cannot be.
Vector unit(const Vector& v) {
  const double largest =
      std::max(std::abs(v.at[0]), std::max(std::abs(v.at[1]), std::abs(v.at[2])));
  if (!(largest > 0x1p-300 && largest < 0x1p300)) return {{0, 0, 0}};
  const double length = std::sqrt(dot(v.at, v.at));
  return {{v.at[0] / length, v.at[1] / length, v.at[2] / length}};
}

}  // namespace

CastDirections::Frame::Frame(const FramedMesh& mesh, const SweepUnits& units)
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

/// Its corners are all that is asked of it.
CastDirections::Frame::Frame(const Aabb& box, const SweepUnits& units)
    : axis{}, unit(0), margin(kMargin) {
  for (int k = 0; k < 3; ++k) {
    const double low = box.min.data()[k] * units.per_metre;
    const double high = box.max.data()[k] * units.per_metre;
    centre[k] = 0.5 * (low + high);
  }
}

CastDirections::Frame::Frame(const Sphere& ball, const SweepUnits& units)
    : axis{}, unit(0), margin(kMargin) {
  for (int k = 0; k < 3; ++k)
    centre[k] = ball.centre.data()[k] * units.per_metre;
}

CastDirections::CastDirections(const FramedMesh& a, const FramedMesh& b, const SweepUnits& units,
                               const double (&direction)[3])
    : CastDirections(Frame(a, units), Frame(b, units), units, direction) {}

CastDirections::CastDirections(const FramedMesh& a, const Aabb& b, const SweepUnits& units,
                               const double (&direction)[3])
    : CastDirections(Frame(a, units), Frame(b, units), units, direction) {}

CastDirections::CastDirections(const FramedMesh& a, const Sphere& b, const SweepUnits& units,
                               const double (&direction)[3])
    : CastDirections(Frame(a, units), Frame(b, units), units, direction) {}

CastDirections::CastDirections(const Frame& a, const Frame& b, const SweepUnits& units,
                               const double (&direction)[3])
    : per_metre_(units.per_metre), a_(a), b_(b) {
  std::copy(direction, direction + 3, direction_);
  // Across the component of d that is largest there is an axis that is not along d.
  int least = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(direction[k]) < std::abs(direction[least])) least = k;
  }
  double axis[3] = {0, 0, 0};
  axis[least] = 1;
  Vector across = unit(cross(direction, axis));
  Vector other = unit(cross(direction, across.at));
  if (direction[(least + 1) % 3] == 0 && direction[(least + 2) % 3] == 0) {
    // Nothing moves: all is across.
    across = {{1, 0, 0}};
    other = {{0, 1, 0}};
  }
  set(0, across.at);
  set(1, other.at);
  set(2, sum(across, other, 1).at);
  set(3, sum(across, other, -1).at);
  set(4, direction);
  set(5, cross(across.at, other.at).at);
}

/// A vector of size 0 says nothing: nothing is beside it, and all is from 0 on.
CastDirections::Limit CastDirections::limit_of(const double (&n)[3]) const {
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

void CastDirections::set(int at, const double (&n)[3]) {
  const int pair = at / 2, lane = at % 2;
  const Limit limit = limit_of(n);
  vectors_.x[pair][lane] = limit.sense * n[0];
  vectors_.y[pair][lane] = limit.sense * n[1];
  vectors_.z[pair][lane] = limit.sense * n[2];
  const auto set_local = [&](Slabs& slabs, const Frame& frame) {
    double local[3];
    for (int k = 0; k < 3; ++k)
      local[k] = limit.sense * dot(n, frame.axis[k]) * frame.unit;
    const bvh::KDopCombination made_of = bvh::combination_of(local);
    for (int term = 0; term < 3; ++term) {
      const bool is_against = made_of.against[term] < 0;
      slabs.low[term] = made_of.slab[term] + (is_against ? kSlabs : 0);
      slabs.high[term] = made_of.slab[term] + (is_against ? 0 : kSlabs);
      slabs.weight[term] = made_of.along[term] + made_of.against[term];
    }
  };
  set_local(slabs_a_[at], a_);
  set_local(slabs_b_[at], b_);
  const bool is_last = pair == kPairs - 1, is_across = limit.most_low < kInfinity;
  shifts_.high[pair][lane] = limit.between + (limit.margin - limit.least_high);
  // Across d the motion changes nothing: what is beyond that is never met. Along it that says no
  // more than by when.
  shifts_.low[pair][lane] = limit.between - (limit.margin + (is_across ? limit.most_low : 0));
  if (is_last) {
    down_[lane] = is_across ? kSurelyLate : limit.down;
  } else if (!is_across) {
    shifts_.low[pair][lane] = -kInfinity;
  }
}

void CastDirections::measure_kdop(Side side, const bvh::FloatKDop& kdop, Pairs pairs,
                                  Span& span) const {
  double bounds[2 * kSlabs];
  for (int i = 0; i < kSlabs; ++i) {
    bounds[i] = double{kdop.min[i]};
    bounds[kSlabs + i] = double{kdop.max[i]};
  }
  const Slabs* slabs = side == Side::A ? slabs_a_ : slabs_b_;
  for (int i = first_of(pairs); i < kPairs; ++i) {
    const Slabs &one = slabs[2 * i], &other = slabs[2 * i + 1];
    TwoLanes low = both(0), high = both(0);
    for (int term = 0; term < 3; ++term) {
      const TwoLanes weight{one.weight[term], other.weight[term]};
      low += weight * TwoLanes{bounds[one.low[term]], bounds[other.low[term]]};
      high += weight * TwoLanes{bounds[one.high[term]], bounds[other.high[term]]};
    }
    span.low[i] = low;
    span.high[i] = high;
  }
  shift(side, pairs, span);
}

void CastDirections::measure_points(Side side, std::span<const Eigen::Vector3d* const> points,
                                    Pairs pairs, Span& span) const {
  const double* centre = frame(side).centre;
  for (std::size_t at = 0; at < points.size(); ++at) {
    TwoLanes p[3];
    for (int k = 0; k < 3; ++k)
      p[k] = both(points[at]->data()[k] * per_metre_ - centre[k]);
    for (int i = first_of(pairs); i < kPairs; ++i) {
      const TwoLanes value = (vectors_.x[i] * p[0] + vectors_.y[i] * p[1]) + vectors_.z[i] * p[2];
      span.low[i] = at == 0 ? value : smaller(span.low[i], value);
      span.high[i] = at == 0 ? value : larger(span.high[i], value);
    }
  }
  shift(side, pairs, span);
}

// Relative to its own centre. The square of n is off by 3 u of itself, for those of what says
// something do not underflow in sum; the root by half of that and one more, and so are the two
// products. What underflows of a radius is far below the margin.
CastDirections::Span CastDirections::of_ball(const Sphere& ball) const {
  constexpr double kBallGrowth = 1 + 8 * kUnitRoundoff;
  const double radius = ball.radius * per_metre_ * kBallGrowth;
  Span span;
  for (int i = 0; i < kPairs; ++i) {
    for (int lane = 0; lane < 2; ++lane) {
      const double n[3] = {vectors_.x[i][lane], vectors_.y[i][lane], vectors_.z[i][lane]};
      span.high[i][lane] = std::sqrt(dot(n, n)) * radius;
      span.low[i][lane] = -span.high[i][lane];
    }
  }
  return span;
}

CastDirections::Span CastDirections::around(const Span& s, const Span& t) {
  Span span;
  for (int i = 0; i < kPairs; ++i) {
    span.low[i] = smaller(s.low[i], t.low[i]);
    span.high[i] = larger(s.high[i], t.high[i]);
  }
  return span;
}

void CastDirections::measure_along(Side side, const double (&n)[3], const Triangle& placed,
                                   double& low, double& high) const {
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

/// The normal is whatever rounding makes of it: the bounds hold for any vector.
CastDirections::Plane CastDirections::plane_of(Side side, const Triangle& placed) const {
  double edge[2][3];
  for (int k = 0; k < 3; ++k) {
    const double from = placed.a.data()[k] * per_metre_;
    edge[0][k] = placed.b.data()[k] * per_metre_ - from;
    edge[1][k] = placed.c.data()[k] * per_metre_ - from;
  }
  const Vector normal = cross(edge[0], edge[1]);
  Plane plane;
  plane.limit = limit_of(normal.at);
  for (int k = 0; k < 3; ++k)
    plane.n[k] = plane.limit.sense * normal.at[k];
  measure_along(side, plane.n, placed, plane.low, plane.high);
  return plane;
}

double CastDirections::first_contact(Side side, const Plane& plane, const Triangle& other,
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

bool CastDirections::take_normal(const double (&normal)[3]) {
  const Vector n = unit({{normal[0], normal[1], normal[2]}});
  if (std::abs(dot(n.at, normal_)) > kNearlyAlike) return false;
  std::copy(n.at, n.at + 3, normal_);
  set(5, normal_);
  return true;
}

}  // namespace graze::contacts
