#include <graze/engine/mesh/rigid/moving_pair.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace graze {
namespace {

constexpr std::uint64_t kNever = ~std::uint64_t{0};

/// Returns how far the centres of both bodies move against each other.
double relative_shift(const RigidMotion& a, const RigidMotion& b) {
  double d[3];
  for (int i = 0; i < 3; ++i)
    d[i] = b.shift().data()[i] - a.shift().data()[i];
  return std::sqrt(dot_product(d, d)) * (1 + 0x1p-40) + 0x1p-500;
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
  grid_ = TimeGrid::for_steps(most, tolerance / 4);
  for (PlacedBodies& placed : placed_)
    placed.time = kNever;
}

void MovingPair::place(std::uint64_t time, PlacedBodies& placed) const {
  const double t = grid_.time(time);
  placed.time = time;
  placed.pose_a = a_.motion.at(t);
  placed.pose_b = b_.motion.at(t);
  const double* m = placed.pose_a.data();  // column-major 4x4
  const double* n = placed.pose_b.data();
  for (int i = 0; i < 3; ++i) {
    placed.between[i] = n[12 + i] - m[12 + i];
    placed.arm_a[i] = m[12 + i] - (a_.motion.centre().data()[i] + t * a_.motion.shift().data()[i]);
    placed.arm_b[i] = n[12 + i] - (b_.motion.centre().data()[i] + t * b_.motion.shift().data()[i]);
    for (int j = 0; j < 3; ++j)
      placed.rotation[i][j] = dot_product(m + 4 * i, n + 4 * j);
  }
}

}  // namespace graze
