#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/narrowphase/volumes/kdop_overlap.h>

namespace graze {

bool intersects(const KDop<18>& kdop_a, const KDop<18>& kdop_b) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    bvh::check_kdop(kdop_a, "k-DOP a");
    bvh::check_kdop(kdop_b, "k-DOP b");
    bool is_hit = true;
    for (int i = 0; i < KDop<18>::kSlabs; ++i) {
      is_hit &= kdop_a.min[i] <= kdop_b.max[i];
      is_hit &= kdop_b.min[i] <= kdop_a.max[i];
    }
    return is_hit;
  });
}

}  // namespace graze
