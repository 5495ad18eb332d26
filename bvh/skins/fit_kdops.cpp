#include <graze/bvh/skins/fit_skins.h>

#include <algorithm>
#include <limits>

namespace graze::bvh {
namespace {

constexpr int kSlabs = KDop<18>::kSlabs;

// A coordinate along a slab's normal is a sum of at most two local coordinates below 2 in size,
// each off by kRounding, and rounds once more.
constexpr double kMargin = 4 * Hulls::kRounding;

FloatKDop fitted(std::span<const Eigen::Vector3d> points) {
  FloatKDop kdop;
  for (int slab = 0; slab < kSlabs; ++slab) {
    const auto& d = kKDopDirections<18>[slab];
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Eigen::Vector3d& point : points) {
      const double* p = point.data();
      const double along = d[0] * p[0] + d[1] * p[1] + d[2] * p[2];
      low = std::min(low, along);
      high = std::max(high, along);
    }
    kdop.min[slab] = rounded_down(low - kMargin);
    kdop.max[slab] = rounded_up(high + kMargin);
  }
  return kdop;
}

FloatKDop merged(const FloatKDop& a, const FloatKDop& b) {
  FloatKDop kdop;
  for (int slab = 0; slab < kSlabs; ++slab) {
    kdop.min[slab] = std::min(a.min[slab], b.min[slab]);
    kdop.max[slab] = std::max(a.max[slab], b.max[slab]);
  }
  return kdop;
}

}  // namespace

std::vector<FloatKDop> fit_kdops(const Tree& tree, const Hulls& hulls) {
  std::vector<FloatKDop> skin(tree.nodes.size());
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {  // children stand behind their parents
    const Node& node = tree.nodes[i];
    skin[i] =
        node.is_leaf() ? fitted(hulls.below(i)) : merged(skin[node.first], skin[node.first + 1]);
  }
  return skin;
}

}  // namespace graze::bvh
