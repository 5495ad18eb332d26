#include <graze/bvh/rays/ray_limits.h>
#include <graze/bvh/rays/ray_tree_walk.h>

namespace graze::bvh {

Open* RayTreeWalk::more_room(std::size_t count) {
  more_room_.resize(count);
  return more_room_.data();
}

void RayTreeWalk::limit_to(double s) {
  state_.limit = ray_limit(s, state_.start);
}

}  // namespace graze::bvh
