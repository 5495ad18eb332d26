#include <graze/bvh/rays/ray_limits.h>
#include <graze/bvh/rays/ray_tree_walk.h>

namespace graze::bvh {

RayTreeWalk::RayTreeWalk(const RayTree& tree) : tree_(tree) {
  state_.open = room_;
  if (tree.most_open > kRoom) [[unlikely]] {
    more_room_.resize(tree.most_open);
    state_.open = more_room_.data();
  }
}

void RayTreeWalk::limit_to(double s) {
  state_.limit = ray_limit(s, state_.start);
}

}  // namespace graze::bvh
