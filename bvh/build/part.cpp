#include <graze/bvh/build/part.h>

namespace graze::bvh {

Part part_of(std::span<const Reference> references, std::size_t begin, std::size_t end, int depth) {
  Part part{begin, end, depth};
  for (const Reference& reference : references.subspan(begin, end - begin)) {
    part.box = merged(part.box, reference.box);
    extend(part.centroids, centroid_of(reference.box));
  }
  return part;
}

}  // namespace graze::bvh
