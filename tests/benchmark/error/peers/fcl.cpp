// FCL: the test of two triangles that its trees of boxes use at their leaves, in double.

#include <fcl/narrowphase/detail/traversal/collision/intersect.h>

#include "tests/benchmark/error/peers/peers.h"

// The library that is linked was compiled for the baseline; wider SIMD would change Eigen's layout.
static_assert(EIGEN_MAX_ALIGN_BYTES == 16, "compile this file without -march or -mavx flags");

namespace graze::benchmark {

void add_fcl(Field& field) {
  add(
      field.triangle_pairs, {"FCL", Origin::Peer, "double", std::nullopt},
      [](const TrianglePair& pair) { return pair; },
      [](const TrianglePair& pair) {
        return fcl::detail::Intersect<double>::intersect_Triangle(pair.a.a, pair.a.b, pair.a.c,
                                                                  pair.b.a, pair.b.b, pair.b.c);
      });
}

}  // namespace graze::benchmark
