#include <graze/bvh/build/build.h>
#include <graze/bvh/build/build_nodes.h>
#include <graze/bvh/build/build_references.h>
#include <graze/bvh/error.h>
#include <graze/bvh/value/boxes.h>

#include <string>
#include <utility>

namespace graze::bvh {

Tree build(References references, const LocalFrame& frame, const BuildSettings& settings) {
  Tree tree;
  tree.frame = frame;
  tree.primitives.resize(references.size);
  tree.nodes = build_nodes(std::move(references), 0, settings, tree.primitives);
  return tree;
}

Tree build(std::span<const Aabb> boxes, const BuildSettings& settings) {
  if (!(settings.empty_place_cost >= 0 && settings.empty_place_cost <= 1)) {
    throw InputError("empty_place_cost: " + std::to_string(settings.empty_place_cost) +
                     " is not from 0 to 1");
  }
  const LocalFrame frame = LocalFrame::around(checked_bounds(boxes));
  return build(references_to(boxes, frame), frame, settings);
}

}  // namespace graze::bvh
