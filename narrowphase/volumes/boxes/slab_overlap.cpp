#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/narrowphase/volumes/aabb_overlap.h>
#include <graze/narrowphase/volumes/boxes/kdop_kernels.h>
#include <graze/narrowphase/volumes/kdop_overlap.h>

namespace graze {

bool intersects(const Aabb& box_a, const Aabb& box_b) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    bvh::check_box(box_a, "box a");
    bvh::check_box(box_b, "box b");
    bool is_hit = true;
    for (int i = 0; i < 3; ++i) {
      is_hit &= box_a.min.data()[i] <= box_b.max.data()[i];
      is_hit &= box_b.min.data()[i] <= box_a.max.data()[i];
    }
    return is_hit;
  });
}

bool intersects(const KDop<18>& kdop_a, const KDop<18>& kdop_b) {
  const narrowphase::KDopPairAnswer answer = narrowphase::look_at_pair(kdop_a, kdop_b);
  if (answer == narrowphase::KDopPairAnswer::Invalid) [[unlikely]] {
    check_kdop(kdop_a, "k-DOP a");
    check_kdop(kdop_b, "k-DOP b");
  }
  return answer == narrowphase::KDopPairAnswer::MayOverlap;
}

}  // namespace graze
