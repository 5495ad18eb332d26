#include <graze/engine/world/contacts/region_ends.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace graze {

using narrowphase::Vec3;

namespace {

// Lengths below this share of the region's size do not matter.
constexpr double kNegligibleLength = 1e-9;

// Ends count as deep as the deepest point if they are less deep by no more than these shares of its
// depth and of the region's size. With a thousandth, tall stacks of drums keep swaying: a corner
// that is no contact sinks until it is one.
constexpr double kLevelDepth = 3e-3, kLevelSize = 1e-5;

using Ends = std::array<std::size_t, 4>;  // the farthest points in four directions

/// Returns column k of the pose's rotation.
Vec3 axis_of(const Pose& pose, std::size_t k) {
  const double* m = pose.data() + 4 * (k % 3);  // column-major 4x4
  return {m[0], m[1], m[2]};
}

/// Returns the axis of a frame that a direction is nearest to, 0 to 5.
std::uint64_t side_of(const Pose& pose, const Vec3& direction) {
  std::uint64_t best = 0;
  double most = -1;
  for (std::uint64_t k = 0; k < 3; ++k) {
    const double along = dot(axis_of(pose, k), direction);
    if (std::abs(along) > most) most = std::abs(along), best = 2 * k + (along < 0);
  }
  return best;
}

std::size_t last_along(std::span<const MetPoints> met, const Vec3& direction, double size) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < met.size(); ++i)
    if (dot(met[i].a - met[best].a, direction) > kNegligibleLength * size) best = i;
  return best;
}

/// Returns the ends in directions across the way out, to which axis k of A is the nearest. The
/// directions are askew to A's axes, as edges seldom are.
Ends ends_about(std::size_t k, std::span<const MetPoints> met, const RegionFrame& region) {
  constexpr double kCosine = 0.95, kSine = 0.31;
  // The depth of a point must not count for how far out it is.
  const auto across = [&](const Vec3& along) {
    return along - region.exit * dot(along, region.exit);
  };
  const Vec3 s = axis_of(region.pose_a, k + 1), t = axis_of(region.pose_a, k + 2);
  const Vec3 u = across(s * kCosine + t * kSine);
  const Vec3 v = across(t * kCosine - s * kSine);
  const auto last = [&](const Vec3& along) { return last_along(met, along, region.size); };
  return {last(u), last(v), last(u * -1), last(v * -1)};
}

/// Puts the deepest point among the ends. On level ground any point may be the deepest by rounding,
/// and an end stands for it. Else the deepest point takes the place and the name of an end, so that
/// a solver finds the impulse of the last step: of an end whose point is another end as well, or of
/// the deepest end, with which it is level where the two change places.
void take_deepest(Ends& ends, std::span<const MetPoints> met, const RegionFrame& region) {
  auto place = std::max_element(ends.begin(), ends.end(), [&](std::size_t s, std::size_t t) {
    return met[s].depth < met[t].depth;
  });
  const std::size_t deepest = deepest_of(met, region.size);
  const double most = met[deepest].depth;
  const double level = kLevelDepth * std::abs(most - region.margin);
  if (most - met[*place].depth <= std::min(level, kLevelSize * region.size)) return;
  for (auto own = ends.end(); own-- != ends.begin();)
    if (std::find(ends.begin(), own, *own) != own) place = own;
  *place = deepest;
}

}  // namespace

std::size_t deepest_of(std::span<const MetPoints> met, double size) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < met.size(); ++i)
    if (met[i].depth > met[best].depth + kSameMetDepth * size) best = i;
  return best;
}

void add_ends(std::span<const MetPoints> met, const RegionFrame& region,
              std::vector<narrowphase::ContactPoint>& contacts) {
  const std::uint64_t side_a = side_of(region.pose_a, -region.exit);
  const std::uint64_t side_b = side_of(region.pose_b, -region.exit);
  Ends ends = ends_about(side_a / 2, met, region);
  take_deepest(ends, met, region);
  for (auto own = ends.begin(); own != ends.end(); ++own) {
    if (std::find(ends.begin(), own, *own) != own) continue;
    contacts.push_back({.point_a = met[*own].a,
                        .point_b = met[*own].b,
                        .normal = -region.exit,
                        .depth = met[*own].depth,
                        .feature_a = side_a << 3 | static_cast<std::uint64_t>(own - ends.begin()),
                        .feature_b = side_b});
  }
}

}  // namespace graze
