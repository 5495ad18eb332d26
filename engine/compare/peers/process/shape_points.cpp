#include <graze/bvh/error.h>
#include <graze/engine/compare/peers/process/shape_points.h>
#include <graze/engine/world/shapes/hull_data.h>
#include <graze/narrowphase/convex/core/hull.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::compare {
namespace {

using narrowphase::Hull;
using narrowphase::Vec3;

bool is_equal(const Vec3& a, const Vec3& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

/// True if the hulls are the same; their faces follow from these members.
bool is_same(const Hull& a, const Hull& b) {
  return is_equal(a.middle, b.middle) && std::equal(a.corners.begin(), a.corners.end(),
                                                    b.corners.begin(), b.corners.end(), is_equal);
}

/// Returns the doubles next to `corner + middle` from which `middle` takes the corner back; at
/// least one.
std::vector<double> sources_of(double corner, double middle) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const double sum = corner + middle;
  std::vector<double> sources;
  for (const double each : {sum, std::nextafter(sum, kFar), std::nextafter(sum, -kFar)})
    if (each - middle == corner) sources.push_back(each);
  if (sources.empty()) sources.push_back(sum);
  return sources;
}

/// Holds one coordinate of all corners: the outermost ones make the middle, too.
class AxisSources {
 public:
  AxisSources(const std::vector<Vec3>& corners, double Vec3::*axis, double middle)
      : middle_(middle), least_(corners.front().*axis), largest_(least_) {
    for (const Vec3& corner : corners) {
      least_ = std::min(least_, corner.*axis);
      largest_ = std::max(largest_, corner.*axis);
    }
    low_ = sources_of(least_, middle).front();
    high_ = sources_of(largest_, middle).front();
    for (const double low : sources_of(least_, middle)) {
      for (const double high : sources_of(largest_, middle)) {
        if (low * 0.5 + high * 0.5 != middle) continue;
        low_ = low;
        high_ = high;
        return;
      }
    }
  }

  double of(double corner) const {
    if (corner == least_) return low_;
    return corner == largest_ ? high_ : sources_of(corner, middle_).front();
  }

 private:
  double middle_;
  double least_;
  double largest_;
  double low_;
  double high_;
};

bool is_same(const HalfSpace& a, const HalfSpace& b) {
  return a.normal == b.normal && a.offset == b.offset;
}

}  // namespace

std::optional<std::vector<Eigen::Vector3d>> points_of(const ConvexHull& hull) {
  const Vec3& middle = data_of(hull).middle;
  const std::vector<Vec3>& corners = data_of(hull).corners;
  const AxisSources x(corners, &Vec3::x, middle.x);
  const AxisSources y(corners, &Vec3::y, middle.y);
  const AxisSources z(corners, &Vec3::z, middle.z);
  std::vector<Eigen::Vector3d> points;
  points.reserve(corners.size());
  for (const Vec3& corner : corners)
    points.emplace_back(x.of(corner.x), y.of(corner.y), z.of(corner.z));
  try {
    if (is_same(data_of(ConvexHull(points)), data_of(hull))) return points;
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
