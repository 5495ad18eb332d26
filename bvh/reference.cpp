#include <graze/bvh/reference.h>
#include <tbb/parallel_for.h>

namespace graze::bvh {
namespace {

/// Boxes that one task converts.
constexpr std::size_t kGrain = 4096;

Bounds bounds_of(const FloatBox& box) {
  return {Lanes{-box.min[0], -box.min[1], -box.min[2], 0},
          Lanes{box.max[0], box.max[1], box.max[2], 0}};
}

}  // namespace

References references_to(std::span<const Aabb> boxes, const LocalFrame& frame) {
  References references(boxes.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, boxes.size(), kGrain),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i < range.end(); ++i) {
                        references.data[i] = reference_to(bounds_of(frame.to_local(boxes[i])),
                                                          static_cast<std::uint32_t>(i));
                      }
                    });
  return references;
}

}  // namespace graze::bvh
