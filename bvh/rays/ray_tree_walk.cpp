#include <graze/bvh/rays/ray_limits.h>
#include <graze/bvh/rays/ray_tree_walk.h>

namespace graze::bvh {

void RayTreeWalk::limit_to(double s) {
  state_.limit = ray_limit(s, state_.start);
}

}  // namespace graze::bvh
