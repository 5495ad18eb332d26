#include <graze/engine/world/body_shapes/gap_to_parts.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shapes/grown_box.h>

#include <algorithm>
#include <cmath>

namespace graze {

Aabb BoxPlacing::operator()(const Aabb& own) const {
  const double* m = pose.data();
  Aabb box;
  for (int i = 0; i < 3; ++i) {
    double low = m[12 + i], high = m[12 + i];
    for (int j = 0; j < 3; ++j) {
      const double at_min = m[4 * j + i] * own.min.data()[j];
      const double at_max = m[4 * j + i] * own.max.data()[j];
      low += std::min(at_min, at_max);
      high += std::max(at_min, at_max);
    }
    box.min.data()[i] = low;
    box.max.data()[i] = high;
  }
  return grown(box, room);
}

// The scale of a pair that is d apart is no more than d and twice the sizes of both: of the one its
// box's diagonal, below twice its longest side, and of a part that of its box likewise.
GapToParts::GapToParts(const Aabb& box, const BoxPlacing& placing, double widest_part)
    : box_(box), placing_(placing), lengths_(4 * (width_of(box) + widest_part)) {}

// With t = kTouchTolerance a distance of what is d apart is no less than d - t (d + lengths); as
// much again is for what roots and sums round. What boxes along one axis say holds of any search.
double GapToParts::to_box(const Aabb& world) const {
  double squares = 0;
  for (int i = 0; i < 3; ++i) {
    const double after = world.min.data()[i] - box_.max.data()[i];
    const double before = box_.min.data()[i] - world.max.data()[i];
    const double gap = std::max(std::max(after, before), 0.0);
    squares += gap * gap;
  }
  const double apart = std::sqrt(squares);
  const double sure = apart - 2 * kTouchTolerance * (apart + lengths_);
  // Where squares overflow nothing is known of the root.
  const double along_one = gap_between(box_, world).gap;
  return std::isfinite(sure) ? std::max(sure, along_one) : along_one;
}

}  // namespace graze
