#include <graze/bvh/boxes.h>
#include <graze/bvh/error.h>

#include <algorithm>
#include <string>

namespace graze::bvh {

void check_boxes(std::span<const Aabb> boxes) {
  if (boxes.empty()) throw InputError("tree: no boxes");
  if (boxes.size() > 0x7fffffff) throw InputError("tree: more than 2^31 - 1 boxes");
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    try {
      check_box(boxes[i], "box");
    } catch (const InputError& error) {
      throw InputError("tree: box " + std::to_string(i) + ": " + error.what());
    }
  }
}

Aabb bounds_of(std::span<const Aabb> boxes) {
  Aabb all = boxes[0];
  for (const Aabb& box : boxes) {
    for (int k = 0; k < 3; ++k) {
      all.min.data()[k] = std::min(all.min.data()[k], box.min.data()[k]);
      all.max.data()[k] = std::max(all.max.data()[k], box.max.data()[k]);
    }
  }
  return all;
}

}  // namespace graze::bvh
