#pragma once

#include <graze/bvh/aabb.h>
#include <graze/bvh/value/local_frame.h>

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <span>

namespace graze::bvh {

/// Points in the frame of their bounds, coordinate by coordinate: q = (p - centre) 2^-exponent,
/// rounded. The largest coordinate is about 1 to 2 whatever the size and place of the points (or
/// down to 2^-74 for points that differ by denormals alone), so that no square or cube overflows
/// or loses precision to underflow.
class LocalPoints {
 public:
  /// Throws InputError as bounding_aabb does.
  explicit LocalPoints(std::span<const Eigen::Vector3d> points);

  std::size_t size() const { return size_; }

  /// True if all points are one.
  bool is_single() const { return bounds_.min == bounds_.max; }

  const Aabb& bounds() const { return bounds_; }
  const LocalFrame& frame() const { return frame_; }

  /// Returns the coordinates k of all points, and up to a multiple of kLanes of the last point
  /// again.
  const double* axis(int k) const { return coordinates_.get() + k * padded_; }
  std::size_t padded_size() const { return padded_; }
  static constexpr std::size_t kLanes = 4;

  Eigen::Vector3d point(std::size_t i) const { return {axis(0)[i], axis(1)[i], axis(2)[i]}; }

  /// Returns the local coordinates of a point, rounded.
  Eigen::Vector3d to_local(const Eigen::Vector3d& point) const;

  /// Returns the point of local coordinates, rounded; infinite where it overflows.
  Eigen::Vector3d to_world(const Eigen::Vector3d& local) const;

 private:
  Aabb bounds_;
  LocalFrame frame_;
  double scale_;
  std::size_t size_;
  std::size_t padded_;
  std::unique_ptr<double[]> coordinates_;
};

/// A point and the square of its distance, in local units.
struct FarPoint {
  std::size_t index;
  double squared_distance;
};

/// Returns the first of the points that are farthest from `centre`, given in local coordinates.
FarPoint farthest_point(const LocalPoints& points, const Eigen::Vector3d& centre);

}  // namespace graze::bvh
