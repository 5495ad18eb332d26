#include "tests/benchmark/volumes/cascade.h"

#include <graze/engine/mesh/pairs/binary_pairs.h>

#include <algorithm>

namespace graze::benchmark {
namespace {

template <typename OnPair>
void for_each_pair(const PlacedMeshView& a, const PlacedMeshView& b, Volume second, Work& work,
                   OnPair&& on_pair) {
  const auto by_cascade = [&](const bvh::RelativeFrame& frame, auto&& use) {
    const NodeVolumes first_a = volumes_of(a.mesh, Volume::Sphere, work);
    const NodeVolumes first_b = volumes_of(b.mesh, Volume::Sphere, work);
    const NodeVolumes second_a = volumes_of(a.mesh, second, work);
    const NodeVolumes second_b = volumes_of(b.mesh, second, work);
    with_separation(second, frame, second_a, second_b, [&](const auto& tight) {
      use(Cascade(bvh::SphereSeparation(frame, first_a.spheres, first_b.spheres), tight));
    });
  };
  for_each_binary_pair(a, b, Touch::Include, work, by_cascade, on_pair);
}

}  // namespace

bool intersects_by_cascade(const PlacedMeshView& a, const PlacedMeshView& b, Volume second,
                           Work& work) {
  bool is_hit = false;
  for_each_pair(a, b, second, work, [&](TrianglePair) {
    is_hit = true;
    return bvh::Walk::Stop;
  });
  return is_hit;
}

TrianglePairs find_pairs_by_cascade(const PlacedMeshView& a, const PlacedMeshView& b, Volume second,
                                    Work& work) {
  TrianglePairs found;
  for_each_pair(a, b, second, work, [&](TrianglePair pair) {
    found.pairs.push_back(pair);
    return bvh::Walk::Continue;
  });
  std::sort(found.pairs.begin(), found.pairs.end());
  return found;
}

}  // namespace graze::benchmark
