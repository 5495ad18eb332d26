#include <graze/bvh/tree/validate.h>

#include <cmath>
#include <vector>

namespace graze::bvh {
namespace {

/// True if the local box holds the box, in exact arithmetic. A rounded difference is within half a
/// step of the exact one, and a float that is smaller than it is smaller by at least one step of
/// doubles: strictly beyond the rounded difference is beyond the exact one.
bool holds(const FloatBox& local, const LocalFrame& frame, const Aabb& box) {
  for (int k = 0; k < 3; ++k) {
    const double low = std::ldexp(box.min.data()[k] - frame.centre[k], -frame.exponent);
    const double high = std::ldexp(box.max.data()[k] - frame.centre[k], -frame.exponent);
    if (!(local.min[k] < low && high < local.max[k])) return false;
  }
  return true;
}

bool holds(const FloatBox& outer, const FloatBox& inner) {
  for (int k = 0; k < 3; ++k) {
    if (!(outer.min[k] <= inner.min[k] && inner.max[k] <= outer.max[k])) return false;
  }
  return true;
}

std::string name(std::size_t node) {
  return "node " + std::to_string(node);
}

class Validator {
 public:
  Validator(const Tree& tree, std::span<const Aabb> boxes)
      : tree_(tree), boxes_(boxes), times_reached_(tree.nodes.size()), times_held_(boxes.size()) {}

  std::optional<std::string> run() {
    if (tree_.nodes.empty()) return "no root";
    if (tree_.primitives.size() != boxes_.size())
      return "another number of primitives than of boxes";
    times_reached_[0] = 1;
    for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
      auto broken = tree_.nodes[i].is_leaf() ? check_leaf(i) : check_inner(i);
      if (broken) return broken;
    }
    for (std::size_t i = 0; i < times_reached_.size(); ++i) {
      if (times_reached_[i] != 1) return name(i) + " is not reached exactly once";
    }
    for (std::size_t i = 0; i < times_held_.size(); ++i) {
      if (times_held_[i] != 1)
        return "primitive " + std::to_string(i) + " is not in exactly one leaf";
    }
    return std::nullopt;
  }

 private:
  std::optional<std::string> check_leaf(std::size_t i) {
    const Node& node = tree_.nodes[i];
    const std::size_t end = std::size_t{node.first} + node.count;
    if (end > tree_.primitives.size()) return name(i) + " has primitives out of range";
    for (std::size_t k = node.first; k < end; ++k) {
      const std::uint32_t primitive = tree_.primitives[k];
      if (primitive >= boxes_.size()) return name(i) + " has a primitive out of range";
      ++times_held_[primitive];
      if (!holds(node.box, tree_.frame, boxes_[primitive])) {
        return name(i) + " does not hold primitive " + std::to_string(primitive);
      }
    }
    return std::nullopt;
  }

  std::optional<std::string> check_inner(std::size_t i) {
    const Node& node = tree_.nodes[i];
    if (node.first <= i) return name(i) + " has children before itself";
    if (std::size_t{node.first} + 1 >= tree_.nodes.size())
      return name(i) + " has children out of range";
    for (std::size_t child = node.first; child <= std::size_t{node.first} + 1; ++child) {
      ++times_reached_[child];
      if (!holds(node.box, tree_.nodes[child].box))
        return name(i) + " does not hold " + name(child);
    }
    return std::nullopt;
  }

  const Tree& tree_;
  std::span<const Aabb> boxes_;
  std::vector<int> times_reached_;
  std::vector<int> times_held_;
};

}  // namespace

std::optional<std::string> find_broken_invariant(const Tree& tree, std::span<const Aabb> boxes) {
  return Validator(tree, boxes).run();
}

}  // namespace graze::bvh
