#include <graze/bvh/value/lanes.h>
#include <graze/bvh/wide/tree/corner_rows.h>

#include <algorithm>
#include <cstring>

namespace graze::bvh {

// Four at a time: the room behind the last row is zero.
float CornerRows::reach() const {
  Lanes reach = all_lanes(0);
  for (std::size_t i = 0; i < kRows * size_; i += 4) {
    Lanes values;
    std::memcpy(&values, values_.data() + i, sizeof(values));
    reach = larger(reach, larger(values, -values));
  }
  return std::max(std::max(reach[0], reach[1]), std::max(reach[2], reach[3]));
}

}  // namespace graze::bvh
