#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <graze/bvh/aabb.h>
#include <graze/bvh/pose.h>
#include <graze/narrowphase/triangle.h>

namespace graze::fuzz {

/// Makes shapes of a fuzzer's bytes. Every sequence of bytes is a shape, with zeros after its end.
/// A point is three coordinates, or a combination of earlier points, so that the fuzzer can ask for
/// shared vertices, collinear and coplanar points in a byte or two; a coordinate is a small
/// integer, a neighbour of an earlier one, or any finite double.
class ByteShapes {
 public:
  ByteShapes(const std::uint8_t* data, std::size_t size) : bytes_(data, size) {}

  std::uint8_t byte();
  bool is_empty() const { return bytes_.empty(); }
  double coordinate();
  Triangle triangle();
  Aabb box();

  /// A rotation, exact or rounded or a little off, and a translation.
  Pose pose();

 private:
  double any_double();
  double neighbour(double value);
  Eigen::Vector3d fresh_point();
  Eigen::Vector3d combined_point();
  Eigen::Vector3d point();
  const Eigen::Vector3d& earlier_point();

  std::span<const std::uint8_t> bytes_;
  std::vector<double> coordinates_;
  std::vector<Eigen::Vector3d> points_;
};

}  // namespace graze::fuzz
