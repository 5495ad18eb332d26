#include <graze/engine/world/bodies/body_motion.h>

#include <algorithm>
#include <cmath>

namespace graze {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double sum_of_sizes(const double* v) {
  return (std::abs(v[0]) + std::abs(v[1])) + std::abs(v[2]);
}

}  // namespace

// A point x of the body goes from R x + t to S x + u. It moves by at most |u - t| + |S - R| |x|,
// with the Frobenius norm for |S - R|. Both sums, their roots and their product are off by less
// than 16 roundings. Placing a point, by law 1 or in any other formula of the narrow phase, is off
// by less than 0x10p-53 of |t| + |x| at each end; and that term is above what squares lose to
// underflow, as no bounding radius is less than kSmallestLength.
double motion_bound(const Pose& from, const Pose& to, double bounding_radius) {
  if (bounding_radius == kInfinity) return kInfinity;
  const double* r = from.data();  // column-major 4x4
  const double* s = to.data();
  double turn = 0;
  double shift = 0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      const double change = s[4 * column + row] - r[4 * column + row];
      (column == 3 ? shift : turn) += change * change;
    }
  }
  const double rounding =
      0x20p-53 * (sum_of_sizes(r + 12) + sum_of_sizes(s + 12) + 2 * bounding_radius);
  return (std::sqrt(shift) + std::sqrt(turn) * bounding_radius) * (1 + 0x20p-53) + rounding;
}

// While a body turns the short way, by an angle of at most pi, the chord from its place to its
// first place grows to the last one, which the Frobenius norm is no less than. at(1) differs from
// `to` by what between() says, and the poses in between are off by their rounding.
double travel_bound(const Pose& from, const Pose& to, double bounding_radius) {
  if (bounding_radius == kInfinity) return kInfinity;
  const double lengths =
      sum_of_sizes(from.data() + 12) + sum_of_sizes(to.data() + 12) + bounding_radius;
  return motion_bound(from, to, bounding_radius) +
         (0x1p-40 * lengths + 4 * kMaxRotationDeviation * bounding_radius);
}

double longer_path(double path, double motion) {
  return next_up(path + motion);
}

bool KnownGap::wants_gap(const GapCost& cost) {
  if (wait_ == kNotAsked) wait_ = tests_left_ = cost.first_wait;
  if (tests_left_ != 0) {
    --tests_left_;
    return false;
  }
  const int longer = 2 * wait_ + 1;
  wait_ =
      skips_ >= cost.worth_it ? 0 : static_cast<std::uint16_t>(std::min<int>(longer, kLongestWait));
  tests_left_ = wait_;
  skips_ = 0;
  return true;
}

// The motions since now are the later paths minus the paths now, each path rounded up at every
// step.
void KnownGap::set_gap(double gap, double path_a, double path_b) {
  limit_ = next_down(next_down(path_a + path_b) + gap);
}

}  // namespace graze
