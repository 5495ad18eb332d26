#include <graze/engine/mesh/curves/placed_corners.h>
#include <graze/narrowphase/triangle_pair/adjacent_triangles.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace graze::contacts {
namespace {

bool is_lower(const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
  return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
}

/// Returns a placed vertex without negative zeros, so that equal positions are equal bit for bit.
Eigen::Vector3d placed_corner(const PlacedMeshView& placed, std::uint32_t vertex) {
  Eigen::Vector3d p = narrowphase::place(placed.pose, placed.mesh.vertices()[vertex]);
  for (int k = 0; k < 3; ++k)
    p.data()[k] += 0.0;
  return p;
}

}  // namespace

PlacedCorners::PlacedCorners(const PlacedMeshView& placed, std::vector<std::uint32_t> triangles)
    : triangles_(std::move(triangles)) {
  std::vector<Eigen::Vector3d> all;
  for (std::uint32_t triangle : triangles_) {
    for (std::uint32_t vertex : placed.mesh.triangles()[triangle])
      all.push_back(placed_corner(placed, vertex));
  }
  std::vector<std::uint32_t> order(all.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return is_lower(all[i], all[j]); });
  corners_.resize(triangles_.size());
  for (std::uint32_t i : order) {
    if (positions_.empty() || is_lower(positions_.back(), all[i])) positions_.push_back(all[i]);
    corners_[i / 3][i % 3] = static_cast<std::uint32_t>(positions_.size() - 1);
  }
  for (const auto& corners : corners_)
    elements_.push_back(elements_of(corners));
}

bool PlacedCorners::is_before(const PlacedCorners& other) const {
  const auto is_sorted_before = [&](const auto& these, const auto& those) {
    return std::lexicographical_compare(these.begin(), these.end(), those.begin(), those.end(),
                                        is_lower);
  };
  if (is_sorted_before(positions_, other.positions_)) return true;
  if (is_sorted_before(other.positions_, positions_)) return false;
  return corners_ < other.corners_;
}

std::size_t PlacedCorners::slot_of(std::uint32_t triangle) const {
  return static_cast<std::size_t>(std::lower_bound(triangles_.begin(), triangles_.end(), triangle) -
                                  triangles_.begin());
}

Elements PlacedCorners::elements_of(std::array<std::uint32_t, 3> c) const {
  std::sort(c.begin(), c.end());
  if (!narrowphase::is_degenerate(hull(c))) return {{c, c}, 1};
  Elements elements{{c, c}, 0};
  for (int i = 0; i < 2; ++i) {
    if (c[i] != c[i + 1]) elements.corners[elements.count++] = {c[i], c[i + 1], c[i + 1]};
  }
  elements.count = std::max(elements.count, 1);
  return elements;
}

Triangle PlacedCorners::hull(const std::array<std::uint32_t, 3>& corner) const {
  return {positions_[corner[0]], positions_[corner[1]], positions_[corner[2]]};
}

Triangle PlacedCorners::hull(const FeatureName& feature) const {
  std::array<std::uint32_t, 3> corner = feature.corner;
  for (int i = feature.count(); i < 3; ++i)
    corner[i] = corner[i - 1];
  return hull(corner);
}

}  // namespace graze::contacts
