#include <graze/bvh/value/lanes.h>
#include <graze/bvh/wide/tree/corner_rows.h>

#include <algorithm>
#include <cstring>

namespace graze::bvh {

// Four values are read at a time: the room behind the last row is zero.
float CornerRows::largest_coordinate() const {
  Lanes largest = all_lanes(0);
  for (std::size_t i = 0; i < kRows * size_; i += 4) {
    Lanes values;
    std::memcpy(&values, values_.data() + i, sizeof(values));
    largest = larger(largest, larger(values, -values));
  }
  return std::max(std::max(largest[0], largest[1]), std::max(largest[2], largest[3]));
}

}  // namespace graze::bvh
