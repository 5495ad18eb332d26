#pragma once

#include <graze/bvh/wide/tree/corner_rows.h>

#include <cstddef>
#include <vector>

namespace graze::bvh {

/// Sums over a range of primitives that tell how it lies in space.
struct RangeMoments {
  double normal[3] = {};    ///< sum of the cross products of two edges: twice the area vector
  double area = 0;          ///< sum of the lengths of these products
  double sum[3] = {};       ///< sum of all corners
  double products[6] = {};  ///< sums of products of all corners' coordinates: xx, yy, zz, xy, yz,
                            ///< zx
};

/// The moments of any range of consecutive primitives, as differences of running sums. One sum in
/// four is kept, and the others made again: all of them would be by far the largest part of what a
/// treelet needs to be built.
class MomentSums {
 public:
  /// Sums the rows, which must outlive the sums.
  explicit MomentSums(const CornerRows& rows);

  /// Returns the moments of the primitives from `begin` to before `end`.
  RangeMoments of(std::size_t begin, std::size_t end) const;

 private:
  static constexpr std::size_t kStep = 4;

  RangeMoments of_first(std::size_t count) const;

  const CornerRows& rows_;
  std::vector<RangeMoments> sums_;  ///< the moments of the first kStep * i primitives
};

}  // namespace graze::bvh
