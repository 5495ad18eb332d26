#include <graze/engine/compare/judge/rational/box_tree.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace graze::compare {
namespace {

constexpr std::uint32_t kLeafSize = 2;

}  // namespace

BoxTree::Box BoxTree::box_of(const Triangle& t) {
  Box box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    box.min[i] = std::min({t.a[axis], t.b[axis], t.c[axis]});
    box.max[i] = std::max({t.a[axis], t.b[axis], t.c[axis]});
  }
  return box;
}

void BoxTree::include(Box& box, const Box& other) {
  for (std::size_t i = 0; i < 3; ++i) {
    box.min[i] = std::min(box.min[i], other.min[i]);
    box.max[i] = std::max(box.max[i], other.max[i]);
  }
}

bool BoxTree::overlap(const Box& a, const Box& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.min[i] > b.max[i] || b.min[i] > a.max[i]) return false;
  }
  return true;
}

// This is ((R_i0 x + R_i1 y) + R_i2 z) + t_i. The sign of a factor says which end of a side gives
// the least product; what is not finite stays so, and overlaps everything that it might.
BoxTree::Box BoxTree::placed(const Pose& pose, const Box& box) {
  Box result;
  for (int i = 0; i < 3; ++i) {
    double min = 0;
    double max = 0;
    for (int j = 0; j < 3; ++j) {
      const auto side = static_cast<std::size_t>(j);
      const double factor = pose(i, j);
      const double low = factor * (factor < 0 ? box.max[side] : box.min[side]);
      const double high = factor * (factor < 0 ? box.min[side] : box.max[side]);
      min = j == 0 ? low : min + low;
      max = j == 0 ? high : max + high;
    }
    result.min[static_cast<std::size_t>(i)] = min + pose(i, 3);
    result.max[static_cast<std::size_t>(i)] = max + pose(i, 3);
  }
  return result;
}

// Each operation is off by a part in 2^53, a square that underflows by less than the smallest
// normal number; one part in 2^48 and that number are more than all of these together.
double BoxTree::gap_below(const Box& a, const Box& b) {
  double square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double gap = std::max({a.min[i] - b.max[i], b.min[i] - a.max[i], 0.0});
    square += gap * gap;
  }
  if (!std::isfinite(square)) square = 0x1.fffffffffffffp+1023;
  return std::sqrt(std::max(square - 0x1p-1000, 0.0)) * (1 - 0x1p-48);
}

BoxTree::BoxTree(std::span<const Triangle> triangles) : order_(triangles.size()) {
  boxes_.reserve(triangles.size());
  for (const Triangle& triangle : triangles)
    boxes_.push_back(box_of(triangle));
  std::iota(order_.begin(), order_.end(), 0U);
  nodes_.reserve(2 * triangles.size());
  nodes_.push_back(node_of(0, static_cast<std::uint32_t>(order_.size())));
}

bool BoxTree::Node::is_leaf() const {
  return count <= kLeafSize;
}

BoxTree::Node BoxTree::node_of(std::uint32_t first, std::uint32_t count) const {
  Box box = boxes_[order_[first]];
  for (std::uint32_t i = 1; i < count; ++i)
    include(box, boxes_[order_[first + i]]);
  return {box, first, count, 0};
}

// Halving keeps the depth below 32.
std::uint32_t BoxTree::left_of(std::uint32_t index) const {
  Node& node = nodes_[index];
  if (node.left != 0) return node.left;
  const Box& box = node.box;
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (box.max[i] / 2 - box.min[i] / 2 > box.max[axis] / 2 - box.min[axis] / 2) axis = i;
  }
  const auto begin = order_.begin() + node.first;
  const std::uint32_t half = node.count / 2;
  std::nth_element(begin, begin + half, begin + node.count, [&](std::uint32_t a, std::uint32_t b) {
    return boxes_[a].min[axis] / 2 + boxes_[a].max[axis] / 2 <
           boxes_[b].min[axis] / 2 + boxes_[b].max[axis] / 2;
  });
  node.left = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back(node_of(node.first, half));
  nodes_.push_back(node_of(node.first + half, node.count - half));
  return node.left;
}

struct BoxTree::OverlapWalk {
  const BoxTree& a;
  const BoxTree& b;
  const std::function<bool(std::uint32_t, std::uint32_t)>& on_pair;

  bool leaf_pairs(const Node& node_a, const Node& node_b) const {
    for (std::uint32_t i = 0; i < node_a.count; ++i) {
      for (std::uint32_t j = 0; j < node_b.count; ++j) {
        const std::uint32_t t_a = a.order_[node_a.first + i];
        const std::uint32_t t_b = b.order_[node_b.first + j];
        if (overlap(a.boxes_[t_a], b.boxes_[t_b]) && !on_pair(t_a, t_b)) return false;
      }
    }
    return true;
  }

  bool walk(std::uint32_t index_a, std::uint32_t index_b) const {
    const Node& node_a = a.nodes_[index_a];
    const Node& node_b = b.nodes_[index_b];
    if (!overlap(node_a.box, node_b.box)) return true;
    if (node_a.is_leaf() && node_b.is_leaf()) return leaf_pairs(node_a, node_b);
    if (node_b.is_leaf() || (!node_a.is_leaf() && node_a.count >= node_b.count)) {
      const std::uint32_t left = a.left_of(index_a);
      return walk(left, index_b) && walk(left + 1, index_b);
    }
    const std::uint32_t left = b.left_of(index_b);
    return walk(index_a, left) && walk(index_a, left + 1);
  }
};

struct BoxTree::PlacedWalk {
  const BoxTree& a;
  const Pose& pose_a;
  const BoxTree& b;
  const Pose& pose_b;
  const std::function<bool(std::uint32_t, std::uint32_t)>& on_pair;

  bool leaf_pairs(const Node& node_a, const Node& node_b) const {
    for (std::uint32_t i = 0; i < node_a.count; ++i) {
      const std::uint32_t t_a = a.order_[node_a.first + i];
      const Box box_a = placed(pose_a, a.boxes_[t_a]);
      for (std::uint32_t j = 0; j < node_b.count; ++j) {
        const std::uint32_t t_b = b.order_[node_b.first + j];
        if (overlap(box_a, placed(pose_b, b.boxes_[t_b])) && !on_pair(t_a, t_b)) return false;
      }
    }
    return true;
  }

  /// Walks two nodes, whose boxes are given as they are placed.
  bool walk(std::uint32_t index_a, const Box& box_a, std::uint32_t index_b,
            const Box& box_b) const {
    if (!overlap(box_a, box_b)) return true;
    const Node& node_a = a.nodes_[index_a];
    const Node& node_b = b.nodes_[index_b];
    if (node_a.is_leaf() && node_b.is_leaf()) return leaf_pairs(node_a, node_b);
    const bool is_a_split = node_b.is_leaf() || (!node_a.is_leaf() && node_a.count >= node_b.count);
    const std::uint32_t left = is_a_split ? a.left_of(index_a) : b.left_of(index_b);
    for (const std::uint32_t child : {left, left + 1}) {
      const bool goes_on = is_a_split
                               ? walk(child, placed(pose_a, a.nodes_[child].box), index_b, box_b)
                               : walk(index_a, box_a, child, placed(pose_b, b.nodes_[child].box));
      if (!goes_on) return false;
    }
    return true;
  }
};

struct BoxTree::NearWalk {
  const BoxTree& a;
  const BoxTree& b;
  double bound;
  const std::function<double(std::uint32_t, std::uint32_t)>& on_pair;

  void leaf_pairs(const Node& node_a, const Node& node_b) {
    for (std::uint32_t i = 0; i < node_a.count; ++i) {
      for (std::uint32_t j = 0; j < node_b.count; ++j) {
        const std::uint32_t t_a = a.order_[node_a.first + i];
        const std::uint32_t t_b = b.order_[node_b.first + j];
        if (gap_below(a.boxes_[t_a], b.boxes_[t_b]) < bound) bound = on_pair(t_a, t_b);
      }
    }
  }

  double gap(std::uint32_t index_a, std::uint32_t index_b) const {
    return gap_below(a.nodes_[index_a].box, b.nodes_[index_b].box);
  }

  void walk(std::uint32_t index_a, std::uint32_t index_b) {
    if (gap(index_a, index_b) >= bound) return;
    const Node& node_a = a.nodes_[index_a];
    const Node& node_b = b.nodes_[index_b];
    if (node_a.is_leaf() && node_b.is_leaf()) return leaf_pairs(node_a, node_b);
    const bool is_a_split = node_b.is_leaf() || (!node_a.is_leaf() && node_a.count >= node_b.count);
    const std::uint32_t left = is_a_split ? a.left_of(index_a) : b.left_of(index_b);
    std::array<std::pair<std::uint32_t, std::uint32_t>, 2> next = {
        {{is_a_split ? left : index_a, is_a_split ? index_b : left},
         {is_a_split ? left + 1 : index_a, is_a_split ? index_b : left + 1}}};
    if (gap(next[1].first, next[1].second) < gap(next[0].first, next[0].second)) {
      std::swap(next[0], next[1]);
    }
    for (const auto& [child_a, child_b] : next)
      walk(child_a, child_b);
  }
};

void BoxTree::halve_all() {
  for (std::uint32_t i = 0; i < nodes_.size(); ++i)
    if (!nodes_[i].is_leaf()) left_of(i);
}

void BoxTree::for_each_placed_overlap(
    const BoxTree& tree_a, const Pose& pose_a, const BoxTree& tree_b, const Pose& pose_b,
    const std::function<bool(std::uint32_t, std::uint32_t)>& on_pair) {
  const PlacedWalk walk{tree_a, pose_a, tree_b, pose_b, on_pair};
  walk.walk(0, placed(pose_a, tree_a.nodes_[0].box), 0, placed(pose_b, tree_b.nodes_[0].box));
}

void BoxTree::for_each_overlap(const BoxTree& tree_a, const BoxTree& tree_b,
                               const std::function<bool(std::uint32_t, std::uint32_t)>& on_pair) {
  OverlapWalk{tree_a, tree_b, on_pair}.walk(0, 0);
}

void BoxTree::for_each_nearer(const BoxTree& tree_a, const BoxTree& tree_b, double bound,
                              const std::function<double(std::uint32_t, std::uint32_t)>& on_pair) {
  NearWalk{tree_a, tree_b, bound, on_pair}.walk(0, 0);
}

}  // namespace graze::compare
