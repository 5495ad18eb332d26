#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

namespace graze::mesh_io {

/// Gives bit-equal positions the same index: a format that repeats the corners of each triangle
/// becomes an indexed mesh. Positions keep the order in which they first come.
class PositionIndex {
 public:
  /// Returns the index of this position, a new one if it has not been seen, in amortised constant
  /// time.
  std::uint32_t add(const Eigen::Vector3d& position);

  std::vector<Eigen::Vector3d> take_positions() { return std::move(positions_); }

 private:
  void grow();

  std::vector<Eigen::Vector3d> positions_;
  std::vector<std::uint32_t> slots_;  ///< open addressing, a power of two, at most half full
};

}  // namespace graze::mesh_io
