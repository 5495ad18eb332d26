#include <graze/engine/mesh/rigid/moving_pair.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace graze {
namespace {

constexpr std::uint64_t kNever = ~std::uint64_t{0};

double dot(const double* a, const double* b) {
  return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

/// How far the centres of both bodies move against each other.
double relative_shift(const RigidMotion& a, const RigidMotion& b) {
  double d[3];
  for (int i = 0; i < 3; ++i)
    d[i] = b.shift().data()[i] - a.shift().data()[i];
  return std::sqrt(dot(d, d)) * (1 + 0x1p-40) + 0x1p-500;
}

/// The fewest halvings after which nothing moves by more than a quarter of the tolerance.
std::uint32_t depth_of(double displacement, double tolerance) {
  std::uint32_t depth = 0;
  for (double step = displacement; step > tolerance / 4; step /= 2)
    ++depth;
  return depth;
}

}  // namespace

MovingPair::MovingPair(const MovingBody& a, const MovingBody& b,
                       const RigidContactSettings& settings)
    : a_(a),
      b_(b),
      shift_(relative_shift(a.motion, b.motion)),
      rounding_(a.rounding + b.rounding),
      grid_(0) {
  const double most = shift_ + (a.turned * a.radius + b.turned * b.radius);
  const double tolerance = std::max({settings.tolerance, 64 * rounding_, 0x1p-44 * most});
  limit_ = settings.clearance + tolerance;
  grid_ = TimeGrid(depth_of(most, tolerance));
  for (PlacedBodies& placed : placed_)
    placed.time = kNever;
}

PlacedBodies& MovingPair::slot_of(std::uint64_t time) {
  // Times of a grid end in zeros; the product spreads them.
  std::size_t place = (time * 0x9e3779b97f4a7c15u) >> 58;
  if (placed_[place].time != time) {
    const std::size_t other = place ^ 1;
    if (placed_[other].time == time || place == recent_) place = other;
  }
  recent_ = place;
  return placed_[place];
}

const PlacedBodies& MovingPair::at(std::uint64_t time) {
  PlacedBodies& placed = slot_of(time);
  if (placed.time == time) return placed;
  const double t = grid_.time(time);
  placed.time = time;
  placed.pose_a = a_.motion.at(t);
  placed.pose_b = b_.motion.at(t);
  const double* m = placed.pose_a.data();  // column-major 4x4
  const double* n = placed.pose_b.data();
  const double* o = a_.tree.frame.centre;
  const double* q = b_.tree.frame.centre;
  for (int i = 0; i < 3; ++i) {
    placed.offset[i] = (((n[i] * q[0] + n[4 + i] * q[1]) + n[8 + i] * q[2]) + n[12 + i]) -
                       (((m[i] * o[0] + m[4 + i] * o[1]) + m[8 + i] * o[2]) + m[12 + i]);
  }
  placed.is_related = false;
  return placed;
}

const PlacedBodies& MovingPair::related(std::uint64_t time) {
  at(time);
  PlacedBodies& placed = placed_[recent_];
  if (placed.is_related) return placed;
  for (int i = 0; i < 3; ++i) {
    const double* axis = placed.pose_a.data() + 4 * i;
    for (int j = 0; j < 3; ++j) {
      placed.rotation[i][j] = dot(axis, placed.pose_b.data() + 4 * j);
      placed.size[i][j] = std::abs(placed.rotation[i][j]);
    }
    placed.offset_in_a[i] = dot(axis, placed.offset);
  }
  placed.is_related = true;
  return placed;
}

MetricBox MovingPair::metric(const bvh::FloatBox& box, double unit) {
  MetricBox result;
  for (int i = 0; i < 3; ++i) {
    const double min = static_cast<double>(box.min[i]);
    const double max = static_cast<double>(box.max[i]);
    result.centre[i] = (min + max) / 2 * unit;
    result.half[i] = (max - min) / 2 * unit;
  }
  return result;
}

double MovingPair::gap(const PlacedBodies& placed, const ApartDirection& direction,
                       const MetricBox& box_a, const MetricBox& box_b) const {
  double between = dot(direction.n, placed.offset);
  double reach = 0;
  for (int i = 0; i < 3; ++i) {
    const double along_a = dot(direction.n, placed.pose_a.data() + 4 * i);
    const double along_b = dot(direction.n, placed.pose_b.data() + 4 * i);
    between += along_b * box_b.centre[i] - along_a * box_a.centre[i];
    reach += std::abs(along_a) * box_a.half[i] + std::abs(along_b) * box_b.half[i];
  }
  return between - reach;
}

bool MovingPair::are_apart(const TimeCell& cell, const ApartDirection& direction,
                           const MetricBox& box_a, const MetricBox& box_b, double bulges) {
  const double least = margin(cell, bulges);
  return gap(at(cell.first), direction, box_a, box_b) > least &&
         gap(at(cell.last()), direction, box_a, box_b) > least;
}

}  // namespace graze
