#include <graze/engine/mesh/curves/surface_sides.h>
#include <graze/narrowphase/predicates/predicates.h>

#include <algorithm>

namespace graze::contacts {
namespace {

using narrowphase::Sign;

Sign side_of_plane(const PlacedCorners& corners, std::uint32_t triangle,
                   const Eigen::Vector3d& point) {
  const std::array<std::uint32_t, 3>& c = corners.corners(triangle);
  return narrowphase::orientation_3d(corners.position(c[0]).data(), corners.position(c[1]).data(),
                                     corners.position(c[2]).data(), point.data());
}

/// Returns the corner of a triangle that is not on one of its edges.
std::uint32_t opposite(const Elements& triangle, const FeatureName& edge) {
  for (std::uint32_t corner : triangle.corners[0]) {
    if (corner != edge.corner[0] && corner != edge.corner[1]) return corner;
  }
  return triangle.corners[0][0];
}

}  // namespace

SurfaceSides::SurfaceSides(const PlacedCorners& corners) : corners_(corners) {
  for (std::uint32_t triangle : corners.triangles()) {
    const Elements& elements = corners.elements(triangle);
    if (!elements.has_area()) continue;
    const std::array<std::uint32_t, 3>& c = elements.corners[0];
    triangles_.push_back({{c}, triangle});
    for (int i = 0; i < 3; ++i) {
      const auto [from, to] = std::minmax(c[i], c[(i + 1) % 3]);
      triangles_.push_back({{{from, to, FeatureName::kNone}}, triangle});
    }
  }
  std::sort(triangles_.begin(), triangles_.end());
}

SurfaceSide SurfaceSides::side_of(const Eigen::Vector3d& point, const FeatureName& feature) const {
  const auto first_at = std::lower_bound(triangles_.begin(), triangles_.end(),
                                         std::pair<FeatureName, std::uint32_t>(feature, 0));
  const auto is_at = [&](std::ptrdiff_t i) {
    return triangles_.end() - first_at > i && first_at[i].first == feature;
  };
  if (!is_at(0)) return SurfaceSide::Unknown;
  const std::uint32_t triangle = first_at->second;
  const Sign first = side_of_plane(corners_, triangle, point);
  if (feature.is_face()) {
    if (first == Sign::Zero) return SurfaceSide::Unknown;
    return first == Sign::Negative ? SurfaceSide::Inside : SurfaceSide::Outside;
  }
  if (!is_at(1) || is_at(2)) return SurfaceSide::Unknown;
  const std::uint32_t neighbour = first_at[1].second;
  const Sign second = side_of_plane(corners_, neighbour, point);
  // The inside is behind both planes of a convex edge, or behind either of a concave one.
  const std::uint32_t corner = opposite(corners_.elements(neighbour), feature);
  const bool is_concave =
      side_of_plane(corners_, triangle, corners_.position(corner)) == Sign::Positive;
  const auto either = [&](Sign sign) { return first == sign || second == sign; };
  const auto both = [&](Sign sign) { return first == sign && second == sign; };
  if (is_concave ? either(Sign::Negative) : both(Sign::Negative)) return SurfaceSide::Inside;
  if (is_concave ? both(Sign::Positive) : either(Sign::Positive)) return SurfaceSide::Outside;
  return SurfaceSide::Unknown;
}

}  // namespace graze::contacts
