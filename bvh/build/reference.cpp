#include <graze/bvh/build/reference.h>
#include <graze/bvh/value/to_local.h>

namespace graze::bvh {

References references_to(std::span<const Aabb> boxes, const LocalFrame& frame) {
  const ToLocal to_local(frame);
  return references_made(boxes.size(), [&](std::size_t i) {
    return to_local.box(boxes[i].min.data(), boxes[i].max.data());
  });
}

References references_to(std::span<const Aabb> boxes, const LocalFrame& frame,
                         std::span<const std::uint32_t> primitives) {
  const ToLocal to_local(frame);
  return references_made(primitives, [&](std::size_t i) {
    return to_local.box(boxes[i].min.data(), boxes[i].max.data());
  });
}

}  // namespace graze::bvh
