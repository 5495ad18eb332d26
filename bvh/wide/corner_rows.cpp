#include <graze/bvh/wide/corner_rows.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {

float CornerRows::reach() const {
  float reach = 0;
  for (const float value : values_)
    reach = std::max(reach, std::abs(value));
  return reach;
}

CornerRows CornerRows::reordered(std::span<const std::uint32_t> order) const {
  CornerRows other(size_);
  for (std::size_t r = 0; r < kRows; ++r) {
    const float* from = values_.data() + r * size_;
    float* to = other.values_.data() + r * size_;
    for (std::size_t i = 0; i < size_; ++i)
      to[i] = from[order[i]];
  }
  return other;
}

}  // namespace graze::bvh
