#include <graze/engine/world/body_shapes/part_tree.h>
#include <graze/engine/world/shapes/grown_box.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace graze {
namespace {

// Up to this many parts are asked about one by one, which costs less than measuring a gap.
constexpr std::uint32_t kLeaf = 4;

Aabb around(const std::vector<Aabb>& boxes, const std::vector<std::uint32_t>& places,
            std::uint32_t first, std::uint32_t count) {
  Aabb box = boxes[places[first]];
  for (std::uint32_t i = first + 1; i < first + count; ++i) {
    const Aabb& next = boxes[places[i]];
    box = {box.min.cwiseMin(next.min), box.max.cwiseMax(next.max)};
  }
  return box;
}

}  // namespace

struct PartTree::Search {
  const std::optional<Aabb>& within;
  double room;
  const GapToParts& gap;
  const Look& look;

  bool is_apart(const Aabb& box) const {
    return within && !share_a_point(grown(box, room), *within);
  }
};

PartTree::PartTree(const std::vector<Aabb>& boxes) : places_(boxes.size()) {
  std::iota(places_.begin(), places_.end(), 0u);
  nodes_.reserve(boxes.size());
  build(boxes, 0, static_cast<std::uint32_t>(boxes.size()));
  nodes_.shrink_to_fit();
}

/// Splits boxes into halves by their middles along the longest side, equal ones by their places.
std::uint32_t PartTree::build(const std::vector<Aabb>& boxes, std::uint32_t first,
                              std::uint32_t count) {
  const auto own = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({around(boxes, places_, first, count), first, count});
  if (count <= kLeaf) return own;
  Eigen::Index axis = 0;
  (nodes_[own].box.max - nodes_[own].box.min).maxCoeff(&axis);
  const auto middle = [&](std::uint32_t place) {
    return boxes[place].min[axis] / 2 + boxes[place].max[axis] / 2;
  };
  const std::uint32_t half = count / 2;
  const auto begin = places_.begin() + first;
  std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t s, std::uint32_t t) {
    return std::pair(middle(s), s) < std::pair(middle(t), t);
  });
  build(boxes, first, half);
  const std::uint32_t second = build(boxes, first + half, count - half);
  nodes_[own].second = second;
  return own;
}

void PartTree::look_at_nearest(const std::optional<Aabb>& within, double room,
                               const GapToParts& gap, double limit, const Look& look) const {
  const Search search{within, room, gap, look};
  if (!search.is_apart(nodes_[0].box) && gap.to_own(nodes_[0].box) <= limit)
    look_in(search, 0, limit);
}

double PartTree::look_in(const Search& search, std::uint32_t node, double limit) const {
  const Node& here = nodes_[node];
  if (here.second == 0) {
    for (std::uint32_t i = here.first; i < here.first + here.count; ++i)
      limit = search.look(places_[i]);
    return limit;
  }
  std::pair<double, std::uint32_t> near[2] = {
      {search.gap.to_own(nodes_[node + 1].box), node + 1},
      {search.gap.to_own(nodes_[here.second].box), here.second}};
  if (near[1] < near[0]) std::swap(near[0], near[1]);
  for (const auto& [least, next] : near) {
    const Node& branch = nodes_[next];
    if (least > limit || search.is_apart(branch.box)) continue;
    if (branch.second == 0 || search.gap.measured(branch.box, limit) <= limit)
      limit = look_in(search, next, limit);
  }
  return limit;
}

}  // namespace graze
