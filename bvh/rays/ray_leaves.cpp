#include <graze/bvh/rays/ray_leaves.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace graze::bvh {
namespace {

/// The grid of a leaf, on which its points are.
class LeafGrid {
 public:
  LeafGrid(const RayNode& node, std::uint32_t lane) {
    for (std::size_t k = 0; k < 3; ++k) {
      low_[k] = node.box[2 * k][lane];
      const double extent = node.box[2 * k + 1][lane] - low_[k];
      per_unit_[k] = extent > 0 ? RayTree::kSteps / extent : 0;
    }
  }

  std::uint32_t packed(const double* point) const {
    std::uint32_t packed = 0;
    for (int k = 2; k >= 0; --k) {
      const double at = std::nearbyint((point[k] - low_[k]) * per_unit_[k]);
      const double kept = std::clamp(at, 0.0, static_cast<double>(RayTree::kSteps));
      packed = packed << RayTree::kBits | static_cast<std::uint32_t>(kept);
    }
    return packed;
  }

 private:
  double low_[3];
  double per_unit_[3];
};

/// The points of a leaf's primitives, each once, in the order in which they are met.
class LeafPoints {
 public:
  LeafPoints(const LeafSource& source, RayChild leaf)
      : primitives_(source.tree.primitives.data() + leaf.place()), leaf_(leaf) {
    const auto numbers = source.corners.numbers();
    for (std::uint32_t i = 0; i < leaf.count(); ++i) {
      for (std::uint32_t c = 0; c < 3; ++c)
        which_[c][i] = place_of(numbers[primitives_[i]][c]);
    }
  }

  std::uint32_t count() const { return count_; }

  void fill(const LeafGrid& grid, const LocalCorners& corners, std::uint32_t* to) const {
    SharedPoints header(leaf_.place(), count_);
    std::uint32_t* const points = to + SharedPoints::kHeader;
    for (std::uint32_t i = 0; i < leaf_.count(); ++i) {
      double corner[3][3];
      corners.of(primitives_[i], corner);
      for (std::uint32_t c = 0; c < 3; ++c) {
        const std::uint32_t which = which_[c][i];
        header.set(i, c, which);
        points[which] = grid.packed(corner[c]);
      }
    }
    std::memcpy(to, &header, sizeof(header));
    std::copy_n(number_, count_, points + count_);
  }

 private:
  std::uint32_t place_of(std::uint32_t number) {
    std::uint32_t* const end = number_ + count_;
    const auto* const at = std::find(number_, end, number);
    if (at == end) number_[count_++] = number;
    return static_cast<std::uint32_t>(at - number_);
  }

  const std::uint32_t* primitives_;
  RayChild leaf_;
  std::uint32_t count_ = 0;
  std::uint32_t number_[3 * RayTree::kLeafSize];
  std::uint32_t which_[3][RayTree::kLeafSize];
};

template <typename Function>
void for_each_leaf(const RayNode& node, const Function& function) {
  for (std::uint32_t lane = 0; lane < RayNode::kWidth; ++lane) {
    if (node.child[lane].is_leaf()) function(lane);
  }
}

}  // namespace

std::optional<std::vector<std::uint32_t>> shared_leaves(const LeafSource& source,
                                                        std::size_t most_words) {
  if (source.corners.numbers().empty()) return std::nullopt;
  std::vector<std::uint32_t> places;
  std::size_t end = 0;
  bool can_share = true;
  for (const RayNode& node : source.nodes) {
    for_each_leaf(node, [&](std::uint32_t lane) {
      const std::uint32_t count = LeafPoints(source, node.child[lane]).count();
      can_share &= count <= SharedPoints::kMost;
      places.push_back(static_cast<std::uint32_t>(end));
      end += SharedPoints::words(count);
    });
    if (!can_share || end > most_words || end > RayChild::kMostPlaces) return std::nullopt;
  }
  places.push_back(static_cast<std::uint32_t>(end));
  return places;
}

void fill_corners(const LeafSource& source, std::size_t node, std::uint32_t* to) {
  for_each_leaf(source.nodes[node], [&](std::uint32_t lane) {
    const RayChild leaf = source.nodes[node].child[lane];
    const LeafGrid grid(source.nodes[node], lane);
    const std::uint32_t count = leaf.count();
    std::uint32_t* const rows = to + std::size_t{3} * leaf.place();
    for (std::uint32_t i = 0; i < count; ++i) {
      double corner[3][3];
      source.corners.of(source.tree.primitives[leaf.place() + i], corner);
      for (std::uint32_t c = 0; c < 3; ++c)
        rows[c * count + i] = grid.packed(corner[c]);
    }
  });
}

void fill_shared_points(const LeafSource& source, std::size_t index, const RayNode& node,
                        std::uint32_t* to) {
  for_each_leaf(node, [&](std::uint32_t lane) {
    LeafPoints(source, source.nodes[index].child[lane])
        .fill(LeafGrid(node, lane), source.corners, to + node.child[lane].place());
  });
}

}  // namespace graze::bvh
