#include <graze/engine/world/contacts/last_touch.h>
#include <graze/narrowphase/convex/gap/closed_gap.h>

#include <algorithm>
#include <cmath>

namespace graze {

using narrowphase::Core;
using narrowphase::CoreGap;
using narrowphase::Vec3;

namespace {

// Bodies that are as near as this share of the body's size touch: a thousandth of what law 15
// leaves to depths on meshes. Solvers of gaps leave open 2^-34 of the pair's scale, which beside a
// large triangle is more: two that may touch, as far as is known then, do.
constexpr double kTouching = 1e-9;

// Polytopes end after a few steps, and round ones near the answer double its digits with each step.
constexpr int kMostSteps = 32;

}  // namespace

std::optional<LastTouch> last_touch(const Core& body, const Core& other, const WayOut& out) {
  const double negligible = kTouching * (body.bounding_radius + body.radius);
  Core moved = body;
  double way = out.length;
  for (int step = 0; step < kMostSteps; ++step) {
    moved.at = body.at + out.direction * way;
    // What is farther apart than the way that is left does not meet.
    const double left = std::max(way - out.least, 0.0) + 2 * negligible;
    const CoreGap gap = nearest(moved, other, {.apart_beyond = body.radius + left});
    const double apart = gap.upper - body.radius;
    const bool may_touch =
        gap.verdict != narrowphase::GapVerdict::NotReached && gap.lower - body.radius <= negligible;
    if (may_touch || apart <= negligible + gap.slack) {
      const Vec3 between = unit_or(gap.point_b - gap.point_a, -out.direction);
      const Vec3 on_body = gap.point_a + between * body.radius - out.direction * way;
      // The two may still be a hair apart, or that deep: the way is what the points are apart.
      const double apart_along = dot(gap.point_b - on_body, out.direction);
      if (std::abs(apart_along - way) <= negligible) way = apart_along;
      return LastTouch{way, on_body, gap.point_b};
    }
    if (gap.lower - body.radius > left) return std::nullopt;
    const double closing = -dot(gap_normal(moved, other, gap), out.direction);
    if (!(closing > 0)) return std::nullopt;
    way -= apart / closing;
    if (way < out.least - negligible) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace graze
