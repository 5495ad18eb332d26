// Law 8: the order in which a walk finds what meets does not depend on which boxes count as near
// beside it, for these may differ between SIMD targets.

#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/query/wide_query.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

/// The pairs that a walk hands out, those that do not meet left out.
std::vector<TrianglePair> met_in_order(const WideQuery& query, std::size_t room,
                                       const std::vector<TrianglePair>& meeting) {
  const std::set<std::pair<std::uint32_t, std::uint32_t>> known = [&] {
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const TrianglePair& pair : meeting)
      pairs.emplace(pair.a, pair.b);
    return pairs;
  }();
  bvh::WidePairWalk walk = query.walk(bvh::WidePairWalk::Goal::AllPairs);
  std::vector<bvh::FoundPair> found(room);
  std::vector<TrianglePair> met;
  while (const std::size_t count = walk.next(found)) {
    for (std::size_t i = 0; i < count; ++i) {
      const TrianglePair pair = query.pair_at(found[i].places);
      if (known.contains({pair.a, pair.b})) met.push_back(pair);
    }
  }
  return met;
}

TEST(WalkOrder, Law8IsThatOfWhatMeetsWhateverElseIsNear) {
  const std::vector<Mesh> meshes{tests::make_sphere(1, 40, 40), tests::make_torus(1, 0.4, 40, 24)};
  RandomSource source(811);
  std::size_t touching = 0;
  for (int n = 0; n < 60; ++n) {
    const Pose pose_a = tests::random_pose(1, source);
    Pose pose_b = tests::random_pose(1, source);
    pose_b.translation() = pose_a.translation() + source.vector(-1, 1);
    const PlacedMeshView a{meshes[static_cast<std::size_t>(n % 2)], pose_a};
    const PlacedMeshView b{meshes[static_cast<std::size_t>(n / 2 % 2)], pose_b};
    const std::vector<TrianglePair> meeting = find_triangle_pairs(a, b).pairs;
    if (meeting.size() < 20) continue;
    ++touching;
    Work work;
    WideQuery query(a, b, work);
    const std::vector<TrianglePair> expected =
        met_in_order(query, bvh::WidePairWalk::kMany, meeting);
    ASSERT_EQ(expected.size(), meeting.size());
    EXPECT_EQ(met_in_order(query, bvh::WidePairWalk::kMostInStep, meeting), expected) << n;
    // With more slack more boxes, and pairs of triangles, cannot be told apart.
    for (const double share : {1e-3, 1e-2, 3e-2}) {
      query.b_in_a.slack = share;
      EXPECT_EQ(met_in_order(query, bvh::WidePairWalk::kMany, meeting), expected) << n;
    }
  }
  EXPECT_GT(touching, 30u);
}

}  // namespace
}  // namespace graze
