#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/convex_hull.h>
#include <graze/engine/world/shape.h>
#include <graze/narrowphase/convex/core/hull.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace graze {
namespace {

const char* name_of(narrowphase::HullDefect defect) {
  switch (defect) {
    case narrowphase::HullDefect::Point:
      return "all points are equal";
    case narrowphase::HullDefect::Line:
      return "all points lie on a line";
    default:
      return "all points lie in a plane";
  }
}

/// Throws unless squares and products of six of the hull's lengths stay within the range of double,
/// as for every shape. It does not matter how thin the hull is.
void check_size(const std::vector<narrowphase::Vec3>& points) {
  narrowphase::Vec3 low = points[0], high = points[0];
  for (const narrowphase::Vec3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double longest = largest(high - low);
  if (longest > 0 && longest < kSmallestLength)
    throw InputError("convex hull: its longest side is below the smallest length");
}

}  // namespace

ConvexHull::ConvexHull(std::span<const Eigen::Vector3d> points) {
  bvh::in_standard_arithmetic([&] {
    if (points.empty()) throw InputError("convex hull: no points");
    std::vector<narrowphase::Vec3> copied;
    copied.reserve(points.size());
    for (const Eigen::Vector3d& point : points) {
      for (int i = 0; i < 3; ++i) {
        if (std::abs(point.data()[i]) <= kLargestLength) continue;
        throw InputError("convex hull: point " + std::to_string(copied.size()) + ": coordinate " +
                             "xyz"[i] + " is not finite or beyond the largest length",
                         {.element = "point", .index = copied.size()});
      }
      copied.push_back({point.data()[0], point.data()[1], point.data()[2]});
    }
    check_size(copied);
    narrowphase::Hull hull;
    const narrowphase::HullDefect defect = narrowphase::build_hull(copied, hull);
    if (defect != narrowphase::HullDefect::None) {
      throw InputError(std::string("convex hull: no volume, ") + name_of(defect));
    }
    hull_ = std::make_shared<const narrowphase::Hull>(std::move(hull));
  });
}

std::size_t ConvexHull::vertex_count() const {
  return hull_->corners.size();
}

Eigen::Vector3d ConvexHull::vertex(std::size_t index) const {
  return bvh::in_standard_arithmetic([&]() -> Eigen::Vector3d {
    const narrowphase::Vec3 corner = hull_->corners.at(index) + hull_->middle;
    return {corner.x, corner.y, corner.z};
  });
}

std::size_t ConvexHull::face_count() const {
  return hull_->contact_faces.size();
}

std::size_t ConvexHull::facet_count() const {
  return hull_->faces.size();
}

std::span<const std::uint32_t> ConvexHull::facet(std::size_t index) const {
  const narrowphase::Hull::Face& face = hull_->faces.at(index);
  return {hull_->loops.data() + face.first, face.count};
}

}  // namespace graze
