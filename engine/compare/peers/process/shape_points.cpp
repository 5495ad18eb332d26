#include <graze/bvh/error.h>
#include <graze/engine/compare/peers/process/shape_points.h>
#include <graze/narrowphase/convex/hull.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace graze::compare {
namespace {

using narrowphase::Hull;
using narrowphase::Vec3;

bool is_equal(const Vec3& a, const Vec3& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

bool is_same(const Hull& a, const Hull& b) {
  if (!is_equal(a.middle, b.middle) || a.loops != b.loops) return false;
  if (a.corners.size() != b.corners.size()) return false;
  for (std::size_t i = 0; i < a.corners.size(); ++i) {
    if (!is_equal(a.corners[i], b.corners[i])) return false;
  }
  return true;
}

/// The double next to `corner + middle`, or that itself, from which `middle` takes it back.
double source_of(double corner, double middle) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const double sum = corner + middle;
  for (const double each : {sum, std::nextafter(sum, kFar), std::nextafter(sum, -kFar)})
    if (each - middle == corner) return each;
  return sum;
}

bool is_same(const HalfSpace& a, const HalfSpace& b) {
  return a.normal == b.normal && a.offset == b.offset;
}

}  // namespace

std::optional<std::vector<Eigen::Vector3d>> points_of(const ConvexHull& hull) {
  const Vec3& middle = hull.data().middle;
  std::vector<Eigen::Vector3d> points;
  points.reserve(hull.vertex_count());
  for (const Vec3& corner : hull.data().corners) {
    points.emplace_back(source_of(corner.x, middle.x), source_of(corner.y, middle.y),
                        source_of(corner.z, middle.z));
  }
  try {
    if (is_same(ConvexHull(points).data(), hull.data())) return points;
  } catch (const Error&) {  // rounding has made it flat
  }
  return std::nullopt;
}

std::optional<HalfSpace> source_of(const HalfSpace& half_space) {
  constexpr int kTries = 512;
  for (int i = 0; i < kTries; ++i) {
    const double scale = 1 + i / static_cast<double>(kTries);
    const HalfSpace source = {scale * half_space.normal, scale * half_space.offset};
    if (is_same(*Shape(source).as<HalfSpace>(), half_space)) return source;
  }
  return std::nullopt;
}

}  // namespace graze::compare
