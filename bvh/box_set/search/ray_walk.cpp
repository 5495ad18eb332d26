#include <graze/bvh/box_set/search/ray_walk.h>
#include <graze/bvh/traverse/traversal.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {
namespace {

struct Open {
  std::uint32_t block;
  std::int32_t level;
  double entry;
};

using OpenStack = TraversalStack<Open, 160>;

/// Returns where the ray enters a lane of a block of upper bounds, whose high halves are rounded
/// outward by less than 2^-20.
double lane_entry(const RaySlabs& ray, const Block& block, std::uint32_t lane, double limit) {
  if (block.row[0][lane] > block.row[3][lane]) return kNever;  // empty
  double low[3], high[3];
  for (int k = 0; k < 3; ++k) {
    low[k] = value_of_key(joined(block.row[k][lane], 0));
    high[k] = value_of_key(joined(block.row[k + 3][lane], 0xffffffffu));
  }
  return padded_entry(ray, low, high, limit);
}

struct Lane {
  std::uint32_t lane;
  double entry;
};

/// Finds the lanes that the ray may meet, the farthest first, as a stack wants them.
std::uint32_t find_lanes(const RaySlabs& ray, const Block& block, double limit, Lane* found) {
  std::uint32_t count = 0;
  for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
    const double entry = lane_entry(ray, block, lane, limit);
    if (entry != kNever) found[count++] = {lane, entry};
  }
  std::sort(found, found + count, [](const Lane& s, const Lane& t) {
    if (s.entry != t.entry) return s.entry > t.entry;
    return s.lane > t.lane;
  });
  return count;
}

void visit_boxes(const TreeView& tree, const RaySlabs& ray, std::uint32_t block, double& limit,
                 const RayVisitor& visit) {
  Lane lanes[kLanes];
  std::uint32_t count = find_lanes(ray, tree.level[0][block], limit, lanes);
  while (count-- > 0) {
    const std::uint32_t lane = lanes[count].lane;
    const Aabb box = box_of_keys(lane_box(tree.level[0][block], tree.low[block], lane));
    if (padded_entry(ray, box.min.data(), box.max.data(), limit) == kNever) continue;
    limit = std::min(limit, visit(tree.proxy[block * kLanes + lane]));
  }
}

}  // namespace

// The box is seen from the ray's origin: where boxes and ray are far from the origin of the
// coordinates, the padding would be lost in their rounding.
double padded_entry(const RaySlabs& ray, const double* low, const double* high, double limit) {
  double from_origin_low[3], from_origin_high[3];
  double farthest = 0;
  for (int k = 0; k < 3; ++k) {
    from_origin_low[k] = low[k] - ray.origin[k];
    from_origin_high[k] = high[k] - ray.origin[k];
    farthest =
        std::max(farthest, std::max(std::abs(from_origin_low[k]), std::abs(from_origin_high[k])));
  }
  const double padding = kRayPadding * farthest;
  if (!std::isfinite(padding)) return 0;
  double padded_low[3], padded_high[3];
  RaySlabs from_zero = ray;
  for (int k = 0; k < 3; ++k) {
    from_zero.origin[k] = 0;
    padded_low[k] = from_origin_low[k] - padding;
    padded_high[k] = from_origin_high[k] + padding;
  }
  return entry(from_zero, padded_low, padded_high, limit);
}

void walk_along(const TreeView& tree, const RaySlabs& ray, double& limit, const RayVisitor& visit) {
  OpenStack open;
  open.push({0, tree.top, 0});
  while (!open.empty()) {
    const Open top = open.pop();
    if (top.entry > limit) continue;
    if (top.level == 0) {
      visit_boxes(tree, ray, top.block, limit, visit);
      continue;
    }
    Lane lanes[kLanes];
    const std::uint32_t count = find_lanes(ray, tree.level[top.level][top.block], limit, lanes);
    for (std::uint32_t i = 0; i < count; ++i)
      open.push({top.block * kLanes + lanes[i].lane, top.level - 1, lanes[i].entry});
  }
}

}  // namespace graze::bvh
