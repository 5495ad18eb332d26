#pragma once

#include <graze/engine/world/bodies/world_state.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace graze {

/// The largest of all distances, and a number beyond it: the distance to a body that does not
/// exist.
inline constexpr double kLargestDistance = std::numeric_limits<double>::max();
inline constexpr double kBeyondAll = std::numeric_limits<double>::infinity();

/// A box around a shape, and the pose of the shape.
struct PosedBox {
  const Aabb& box;
  const Pose& pose;
};

/// Returns a length, metres, such that no shape in one box is nearer to one in the other than that,
/// by distance(), which knows distances to 2^-34 of the sum of all coordinates, those of the poses
/// included.
inline double least_distance(const PosedBox& a, const PosedBox& b) {
  double squares = 0;
  double sizes = 0;
  for (int k = 0; k < 3; ++k) {
    const double low_a = a.box.min.data()[k], high_a = a.box.max.data()[k];
    const double low_b = b.box.min.data()[k], high_b = b.box.max.data()[k];
    const double gap = std::max(0.0, std::max(low_a - high_b, low_b - high_a));
    squares += gap * gap;
    sizes += (std::abs(low_a) + std::abs(high_a)) + (std::abs(low_b) + std::abs(high_b));
    sizes += std::abs(a.pose.data()[12 + k]) + std::abs(b.pose.data()[12 + k]);
  }
  if (!(squares <= kLargestDistance)) return 0;
  return std::sqrt(squares) * (1 - 0x1p-20) - 0x1p-28 * sizes;
}

/// A body, and a length, metres, such that it is surely as far away as that.
struct BodyAway {
  double least;
  std::uint32_t index;
};

/// Calls `ask(index)` for bodies that are asked for, each at most once, until none that is left can
/// be nearer to a box than the least distance so far, which `ask` returns and which begins as
/// `least`. Searches in boxes that grow until the nearest body is nearer than all outside can be;
/// this is so in a box that is grown by the body's distance. In each box the bodies with the
/// nearest boxes come first.
template <typename Ask>
void World::State::for_nearest(const PosedBox& own, const BodyQuerySettings& query, double least,
                               const Ask& ask) const {
  std::vector<std::uint32_t> seen;  // ascending
  std::vector<BodyAway> next;
  for (double width = least <= kLargestDistance ? least : width_of(own.box);; width *= 4) {
    const bool is_all = !(width < kLargestDistance);
    std::vector<std::uint32_t> found =
        find_bodies(grown(own.box, std::min(width, kLargestDistance)), query);
    next.clear();
    for (const std::uint32_t index : found) {
      if (std::binary_search(seen.begin(), seen.end(), index)) continue;
      const Bodies::Body& body = all.bodies[index];
      next.push_back({least_distance(own, {broad.box(broad.id(body.box)), body.pose}), index});
    }
    std::sort(next.begin(), next.end(), [](const BodyAway& s, const BodyAway& t) {
      return s.least != t.least ? s.least < t.least : s.index < t.index;
    });
    for (const BodyAway& body : next) {
      if (body.least > least) break;
      least = ask(body.index);
    }
    seen = std::move(found);
    if (is_all || least <= width || seen.size() == all.ids.live_count()) return;
    if (least <= kLargestDistance) width = least / 4;
  }
}

}  // namespace graze
