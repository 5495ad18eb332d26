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

}  // namespace graze::bvh
