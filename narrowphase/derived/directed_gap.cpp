// With M the largest coordinate and u the unit roundoff: a product of the direction, of 1-norm at
// most 1.74, with a corner is off by 5 u * 1.74 M, and so are two of them, together 17.4 u M; their
// difference rounds 3.5 u M. The direction is at most 1 + 4 u long, so that the gap along it
// exceeds the distance by no more than 4 u * 3.5 M. The distance as returned may be less than the
// true one by 4 ulp of 2 M, 16 u M. The sum, 51 u M, leaves 13 u M for the rounding of limit +
// margin, where the limit is at most 3.5 M (beyond that nothing is beyond it).

#include <graze/narrowphase/derived/directed_gap.h>
#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::narrowphase {
namespace {

// Between these the offset between two points has no components that underflow visibly, and squares
// and sums do not overflow.
constexpr double kSmallest = 0x1p-400;
constexpr double kLargest = 0x1p+400;

double dot(const double (&direction)[3], const Eigen::Vector3d& p) {
  return direction[0] * p.data()[0] + direction[1] * p.data()[1] + direction[2] * p.data()[2];
}

}  // namespace

DirectedGap::DirectedGap(double largest)
    : margin_(largest <= kLargest ? 64 * 0x1p-53 * largest + 0x1p-1000
                                  : std::numeric_limits<double>::infinity()) {}

void DirectedGap::set_direction(const TriangleDistance& found) {
  double offset[3];
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    offset[k] = found.point_b.data()[k] - found.point_a.data()[k];
    square += offset[k] * offset[k];
  }
  const bool is_usable = square >= kSmallest && square <= kLargest;
  const double length = std::sqrt(square);
  for (int k = 0; k < 3; ++k)
    direction_[k] = is_usable ? offset[k] / length : 0;
}

double DirectedGap::end_of(const Triangle& triangle_a) const {
  return std::max(dot(direction_, triangle_a.a),
                  std::max(dot(direction_, triangle_a.b), dot(direction_, triangle_a.c)));
}

double DirectedGap::start_of(const Triangle& triangle_b) const {
  return std::min(dot(direction_, triangle_b.a),
                  std::min(dot(direction_, triangle_b.b), dot(direction_, triangle_b.c)));
}

}  // namespace graze::narrowphase
