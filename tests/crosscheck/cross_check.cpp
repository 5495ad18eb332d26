#include "tests/crosscheck/cross_check.h"

#include <graze/engine/cases/to_case.h>
#include <graze/engine/compare/compare.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/files/failed_case.h"

namespace graze::tests {
namespace {

void expect_graze_right(const compare::Comparison& comparison) {
  EXPECT_EQ(comparison.graze_wrong, 0u);
  for (const compare::Difference& d : comparison.differences) {
    EXPECT_EQ(d.graze_says, d.truth) << "triangles " << d.pair.a << " and " << d.pair.b;
  }
}

}  // namespace

CrossCheckCounts cross_check(const Mesh& mesh_a, const Mesh& mesh_b,
                             const std::vector<Pose>& poses) {
  const compare::FclMesh fcl_a(mesh_a);
  const compare::FclMesh fcl_b(mesh_b);
  CrossCheckCounts counts;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    SCOPED_TRACE("pose " + std::to_string(i));
    const compare::Side side_a = {{mesh_a}, fcl_a};
    const compare::Side side_b = {{mesh_b, poses[i]}, fcl_b};
    const CaseOnFailure keep([&] {
      return to_case(side_a.placed, side_b.placed,
                     find_triangle_pairs(side_a.placed, side_b.placed));
    });
    const compare::Comparison pairs = compare_pairs(side_a, side_b);
    const compare::Comparison any = compare_any(side_a, side_b);
    expect_graze_right(pairs);
    expect_graze_right(any);
    EXPECT_EQ(any.graze_intersects, pairs.graze_intersects);
    ++(any.graze_intersects ? counts.intersecting : counts.apart);
    counts.pairs += pairs.graze_pairs;
    counts.differences += pairs.differences.size();
  }
  return counts;
}

}  // namespace graze::tests
