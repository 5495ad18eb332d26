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

constexpr int kSlabs = KDop<18>::kSlabs;

// If something lies beyond margins across d, by whatever, that times this is beyond any limit; or
// it is so little beyond that it need not be told.
constexpr double kSurelyLate = 0x1p1000;

// The cosine of 4 degrees: unit vectors with a larger product are nearly alike.
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

/// Returns the vector with length 1, zero if that cannot be.
Vector unit(const Vector& v) {
  const double largest =
      std::max(std::abs(v.at[0]), std::max(std::abs(v.at[1]), std::abs(v.at[2])));
  if (!(largest > 0x1p-300 && largest < 0x1p300)) return {{0, 0, 0}};
  const double length = std::sqrt(dot(v.at, v.at));
  return {{v.at[0] / length, v.at[1] / length, v.at[2] / length}};
}

}  // namespace

CastDirections::CastDirections(const FramedMesh& a, const Aabb& b, const SweepUnits& units,
                               const double (&direction)[3])
    : CastDirections(
          CastPlanes(CastPlanes::Frame(a, units), CastPlanes::Frame(b, units), units, direction),
          direction) {}

CastDirections::CastDirections(const FramedMesh& a, const Sphere& b, const SweepUnits& units,
                               const double (&direction)[3])
    : CastDirections(
          CastPlanes(CastPlanes::Frame(a, units), CastPlanes::Frame(b, units), units, direction),
          direction) {}

CastDirections::CastDirections(const CastPlanes& planes, const double (&direction)[3])
    : planes_(planes) {
  // The coordinate axis along which d has its smallest component is not along d.
  int least = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(direction[k]) < std::abs(direction[least])) least = k;
  }
  double axis[3] = {0, 0, 0};
  axis[least] = 1;
  Vector across = unit(cross(direction, axis));
  Vector other = unit(cross(direction, across.at));
  if (direction[(least + 1) % 3] == 0 && direction[(least + 2) % 3] == 0) {
    // Nothing moves: every vector is across.
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

void CastDirections::set(int at, const double (&n)[3]) {
  const int pair = at / 2, lane = at % 2;
  const CastPlanes::Limit limit = planes_.limit_of(n);
  vectors_.x[pair][lane] = limit.sense * n[0];
  vectors_.y[pair][lane] = limit.sense * n[1];
  vectors_.z[pair][lane] = limit.sense * n[2];
  const CastPlanes::Frame& frame = planes_.frame(Side::A);
  double local[3];
  for (int k = 0; k < 3; ++k)
    local[k] = limit.sense * dot(n, frame.axis[k]) * frame.unit;
  const bvh::KDopCombination made_of = bvh::combination_of(local);
  Slabs& slabs = slabs_[at];
  for (int term = 0; term < 3; ++term) {
    const bool is_against = made_of.against[term] < 0;
    slabs.low[term] = made_of.slab[term] + (is_against ? kSlabs : 0);
    slabs.high[term] = made_of.slab[term] + (is_against ? 0 : kSlabs);
    slabs.weight[term] = made_of.along[term] + made_of.against[term];
  }
  const bool is_last = pair == kPairs - 1, is_across = limit.most_low < kInfinity;
  shifts_.high[pair][lane] = limit.between + (limit.margin - limit.least_high);
  // Across d the motion changes nothing: what is beyond that is never met. Along it, it only says
  // by when.
  shifts_.low[pair][lane] = limit.between - (limit.margin + (is_across ? limit.most_low : 0));
  if (is_last) {
    down_[lane] = is_across ? kSurelyLate : limit.down;
  } else if (!is_across) {
    shifts_.low[pair][lane] = -kInfinity;
  }
}

void CastDirections::measure_kdop(const bvh::FloatKDop& kdop, Pairs pairs, Span& span) const {
  double bounds[2 * kSlabs];
  for (int i = 0; i < kSlabs; ++i) {
    bounds[i] = double{kdop.min[i]};
    bounds[kSlabs + i] = double{kdop.max[i]};
  }
  for (int i = first_of(pairs); i < kPairs; ++i) {
    const Slabs &one = slabs_[2 * i], &other = slabs_[2 * i + 1];
    TwoLanes low = both(0), high = both(0);
    for (int term = 0; term < 3; ++term) {
      const TwoLanes weight{one.weight[term], other.weight[term]};
      low += weight * TwoLanes{bounds[one.low[term]], bounds[other.low[term]]};
      high += weight * TwoLanes{bounds[one.high[term]], bounds[other.high[term]]};
    }
    span.low[i] = low;
    span.high[i] = high;
  }
  shift(Side::A, pairs, span);
}

void CastDirections::measure_points(Side side, std::span<const Eigen::Vector3d* const> points,
                                    Pairs pairs, Span& span) const {
  const double* centre = planes_.frame(side).centre;
  const double per_metre = planes_.per_metre();
  for (std::size_t at = 0; at < points.size(); ++at) {
    TwoLanes p[3];
    for (int k = 0; k < 3; ++k)
      p[k] = both(points[at]->data()[k] * per_metre - centre[k]);
    for (int i = first_of(pairs); i < kPairs; ++i) {
      const TwoLanes value = (vectors_.x[i] * p[0] + vectors_.y[i] * p[1]) + vectors_.z[i] * p[2];
      span.low[i] = at == 0 ? value : smaller(span.low[i], value);
      span.high[i] = at == 0 ? value : larger(span.high[i], value);
    }
  }
  shift(side, pairs, span);
}

// The extent is relative to the ball's own centre. The square of n is off by 3 u of itself, for
// those of what says something do not underflow in sum; the root by half of that and one more, and
// so are the two products. What underflows of a radius is far below the margin.
CastDirections::Span CastDirections::of_ball(const Sphere& ball) const {
  constexpr double kBallGrowth = 1 + 8 * kUnitRoundoff;
  const double radius = ball.radius * planes_.per_metre() * kBallGrowth;
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

bool CastDirections::take_normal(const double (&normal)[3]) {
  const Vector n = unit({{normal[0], normal[1], normal[2]}});
  if (std::abs(dot(n.at, normal_)) > kNearlyAlike) return false;
  std::copy(n.at, n.at + 3, normal_);
  set(5, normal_);
  return true;
}

}  // namespace graze::contacts
