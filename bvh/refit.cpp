#include <graze/bvh/boxes.h>
#include <graze/bvh/error.h>
#include <graze/bvh/refit.h>

#include <string>

namespace graze::bvh {

void refit(Tree& tree, std::span<const Aabb> boxes) {
  const Aabb bounds = checked_bounds(boxes);
  if (boxes.size() != tree.primitives.size()) {
    throw InputError("refit: " + std::to_string(boxes.size()) + " boxes for a tree of " +
                     std::to_string(tree.primitives.size()));
  }
  tree.frame = LocalFrame::around(bounds);
  // Children stand behind their parents.
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    Node& node = tree.nodes[i];
    if (!node.is_leaf()) {
      node.box = merged(tree.nodes[node.first].box, tree.nodes[node.first + 1].box);
      continue;
    }
    node.box = empty_box();
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
      node.box = merged(node.box, tree.frame.to_local(boxes[tree.primitives[k]]));
    }
  }
}

}  // namespace graze::bvh
