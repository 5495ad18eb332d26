#include <graze/engine/world/body_shapes/gap_to_parts.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shapes/grown_box.h>
#include <graze/engine/world/shapes/shape_work.h>

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

// The scale of a pair that is d apart is at most d and twice the sizes of both. Each size is at
// most the diagonal of a box, which is below twice its longest side.
GapToParts::GapToParts(const PartSeeker& seeker, const BoxPlacing& placing, double widest_part)
    : seeker_(seeker), placing_(placing), lengths_(4 * (width_of(seeker.box) + widest_part)) {}

// With t = kTouchTolerance the distance of shapes that are d apart is no less than d - t (d +
// lengths); as much again is for the rounding of roots and sums.
double GapToParts::sure(double apart) const {
  return apart - 2 * kTouchTolerance * (apart + lengths_);
}

// The gap of boxes along one axis holds for any search. Where squares overflow nothing is known of
// the root.
double GapToParts::to_box(const Aabb& world) const {
  double squares = 0;
  for (int i = 0; i < 3; ++i) {
    const double after = world.min.data()[i] - seeker_.box.max.data()[i];
    const double before = seeker_.box.min.data()[i] - world.max.data()[i];
    const double gap = std::max(std::max(after, before), 0.0);
    squares += gap * gap;
  }
  const double apart = sure(std::sqrt(squares));
  const double along_one = gap_between(seeker_.box, world).gap;
  return std::isfinite(apart) ? std::max(apart, along_one) : along_one;
}

// A box that is given the room of parts' boxes holds the parts wherever rounding puts them.
double GapToParts::measured(const Aabb& own, double limit) const {
  if (seeker_.shape == nullptr && seeker_.gap_to_box == nullptr) return to_own(own);
  Pose middle = Pose::Identity();
  middle.translation() = own.min / 2 + own.max / 2;
  const Eigen::Vector3d half = own.max / 2 - own.min / 2;
  const double room = std::max(placing_.room, kSmallestLength);
  const Shape box = Box{half + Eigen::Vector3d::Constant(room)};
  const Pose pose = placed_part(placing_.pose, middle);
  if (seeker_.gap_to_box != nullptr) return sure((*seeker_.gap_to_box)({box, pose}, limit));
  return sure(distance(*seeker_.shape, {box, pose}, &shape_work()).lower_bound);
}

}  // namespace graze
