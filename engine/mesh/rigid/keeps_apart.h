#pragma once

// This is private to engine/mesh/rigid.

#include <graze/engine/mesh/rigid/moving_pair.h>

#include <algorithm>
#include <cmath>

namespace graze {

/// The answers of a direction about parts of two bodies in a span of time.
enum class Apart {
  Always,  ///< they do not come as near as the limit
  AtEnds,  ///< they are further apart at both ends, but may bulge towards each other in between
  Unsure
};

/// A direction at one time, in the frames of both bodies.
struct SeenDirection {
  double in_a[3];
  double in_b[3];

  SeenDirection(const PlacedBodies& placed, const double (&n)[3]) {
    for (int i = 0; i < 3; ++i) {
      in_a[i] = dot_product(n, placed.pose_a.data() + 4 * i);
      in_b[i] = dot_product(n, placed.pose_b.data() + 4 * i);
    }
  }
};

/// Returns how far B begins behind where A ends.
template <typename Part>
double gap_along(const PlacedBodies& placed, const ApartDirection& direction, const Part& a,
                 const Part& b) {
  const SeenDirection seen(placed, direction.n);
  return dot_product(direction.n, placed.between) +
         (b.along(seen.in_b).low - a.along(seen.in_a).high);
}

/// Returns by how much parts of both, together, may leave the line between their places at both
/// ends towards each other.
///
/// Let a body turn by w in a span, and let q be a point of it as seen from the axis, at right
/// angles to that: at most r long. Along a direction n its second derivative over the span is -w^2
/// (n . q), for a shift adds nothing; so it leaves the line towards -n by no more than w^2 / 8
/// times the largest -(n . q) on its way, or not at all if that is negative. And n . q itself is,
/// likewise, not below the lesser of its values at both ends by more than w^2 / 8 r.
template <typename Part>
double bulge(MovingPair& pair, const TimeSpan& span, const ApartDirection& direction, const Part& a,
             const Part& b) {
  const double length = pair.grid().length(span);
  double most_a = 0, most_b = 0;  // the largest n . q of A, and -(n . q) of B
  const auto across = [&](const RigidMotion& motion, double(&n)[3]) {
    const double* axis = motion.axis().data();
    const double along = dot_product(direction.n, axis);
    for (int i = 0; i < 3; ++i)
      n[i] = direction.n[i] - along * axis[i];
  };
  double n_a[3], n_b[3];
  across(pair.a().motion, n_a);
  across(pair.b().motion, n_b);
  for (const std::uint64_t time : {span.first, span.last}) {
    const PlacedBodies& placed = pair.at(time);
    const double arm_a = dot_product(n_a, placed.arm_a);
    const double arm_b = dot_product(n_b, placed.arm_b);
    most_a = std::max(most_a, arm_a + a.along(SeenDirection(placed, n_a).in_a).high);
    most_b = std::max(most_b, -(arm_b + b.along(SeenDirection(placed, n_b).in_b).low));
  }
  const auto of = [&](double turned, double radius, double most) {
    const double share = turned * length * (turned * length) / 8;
    return share * std::min(radius, most + share * radius + pair.rounding());
  };
  return of(pair.a().turned, a.radius, most_a) + of(pair.b().turned, b.radius, most_b);
}

/// Returns whether a direction keeps two parts, in the frames of their bodies, further apart than
/// the limit in the whole span.
template <typename Part>
Apart keeps_apart(MovingPair& pair, const TimeSpan& span, const ApartDirection& direction,
                  const Part& a, const Part& b) {
  const double at_first = gap_along(pair.at(span.first), direction, a, b);
  if (!(at_first > pair.sure_limit())) return Apart::Unsure;  // half of all cases end here
  const double gap = std::min(at_first, gap_along(pair.at(span.last), direction, a, b));
  const double spare = gap - pair.sure_limit();
  if (!(spare > 0)) return Apart::Unsure;
  const double length = pair.grid().length(span);
  const double turned_a = pair.a().turned * length, turned_b = pair.b().turned * length;
  const double most = (turned_a * turned_a * a.radius + turned_b * turned_b * b.radius) / 8;
  // A share of what is to spare is left for the rounding of these lines.
  const double least = spare * (1 - 0x1p-20);
  if (most < least || bulge(pair, span, direction, a, b) < least) return Apart::Always;
  return Apart::AtEnds;
}

}  // namespace graze
