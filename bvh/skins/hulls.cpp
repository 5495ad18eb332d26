#include <graze/bvh/error.h>
#include <graze/bvh/skins/hulls.h>

#include <cmath>
#include <string>

namespace graze::bvh {

Hulls::Hulls(const Tree& tree, std::span<const Eigen::Vector3d> points, std::size_t per_primitive)
    : points_(points.size()), primitives_below_(tree.nodes.size()), per_primitive_(per_primitive) {
  if (points.size() != tree.primitives.size() * per_primitive) {
    throw InputError("skin: " + std::to_string(points.size()) + " points for a tree of " +
                     std::to_string(tree.primitives.size()) + " primitives");
  }
  // The points are rounded as in LocalFrame::to_local: once, in the difference; scaling is exact,
  // but for what vanishes below the smallest double.
  const double scale = std::ldexp(1.0, -tree.frame.exponent);
  for (std::size_t i = 0; i < tree.primitives.size(); ++i) {
    for (std::size_t j = 0; j < per_primitive; ++j) {
      const double* point = points[tree.primitives[i] * per_primitive + j].data();
      double* local = points_[i * per_primitive + j].data();
      for (int k = 0; k < 3; ++k)
        local[k] = (point[k] - tree.frame.centre[k]) * scale;
    }
  }
  // Children stand behind their parents, and the first child's primitives before the second's.
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    const Node& node = tree.nodes[i];
    primitives_below_[i] = node.is_leaf() ? Range{node.first, node.first + node.count}
                                          : Range{primitives_below_[node.first].first,
                                                  primitives_below_[node.first + 1].end};
  }
}

std::span<const Eigen::Vector3d> Hulls::below(std::size_t node) const {
  const Range range = primitives_below_[node];
  return std::span(points_).subspan(range.first * per_primitive_,
                                    (range.end - range.first) * per_primitive_);
}

}  // namespace graze::bvh
