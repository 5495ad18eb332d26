#pragma once

#include <cstddef>
#include <vector>

namespace graze::bvh {

/// Primitives that are the convex hulls of three points each, coordinate by coordinate, rounded to
/// float. Four values may be read from any place of a row on; what lies behind the row is finite.
class CornerRows {
 public:
  static constexpr std::size_t kRows = 9;

  explicit CornerRows(std::size_t size) : size_(size), values_(kRows * size + kRoom) {}

  std::size_t size() const { return size_; }

  /// Return coordinate k of corner c of all primitives.
  float* row(std::size_t c, std::size_t k) { return values_.data() + (3 * c + k) * size_; }
  const float* row(std::size_t c, std::size_t k) const {
    return values_.data() + (3 * c + k) * size_;
  }

  /// Returns the largest size of a coordinate.
  float largest_coordinate() const;

 private:
  static constexpr std::size_t kRoom = 3;  ///< room for whole vectors that begin in the last row

  std::size_t size_;
  std::vector<float> values_;
};

}  // namespace graze::bvh
