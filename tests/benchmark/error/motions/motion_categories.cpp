#include "tests/benchmark/error/motions/motion_categories.h"

#include <cmath>

#include "tests/narrowphase/motion/random_paths.h"
#include "tests/narrowphase/motion/rational_contact.h"

namespace graze::benchmark {
namespace {

/// The sets that are made for motion_queries: three of meshes, and then the kinds of random paths,
/// of which the first is in general position.
constexpr std::size_t kOrdinarySets = 4;
constexpr std::size_t kMotionSets = 3 + tests::kPathKinds;

bool are_floats(const PointPath& path) {
  for (const Eigen::Vector3d* p : {&path.start, &path.end}) {
    for (int k = 0; k < 3; ++k) {
      const double x = p->data()[k];
      if (std::abs(x) > 0x1p127 || static_cast<double>(static_cast<float>(x)) != x) return false;
    }
  }
  return true;
}

bool are_floats(const MotionQuery& query) {
  return are_floats(query.edge_a.a) && are_floats(query.edge_a.b) && are_floats(query.edge_b.a) &&
         are_floats(query.edge_b.b);
}

bool do_meet(const MotionQuery& query) {
  constexpr StartContact kCounts = StartContact::Counts;
  return query.is_edges
             ? oracle::rational_first_contact(query.edge_a, query.edge_b, kCounts).has_value()
             : oracle::rational_first_contact(query.point, query.triangle, kCounts).has_value();
}

enum class MotionFeatures { PointAndTriangle, Edges };

Category<MotionQuery> motion_category(std::size_t index, const Sizes& sizes,
                                      MotionFeatures features) {
  const MotionSet set = made_sets(static_cast<int>(2 * sizes.motions))[index];
  Category<MotionQuery> category{set.name, index < kOrdinarySets, true, {}, {}, sizes.motions};
  for (const MotionQuery& query : set.queries) {
    if (query.is_edges != (features == MotionFeatures::Edges)) continue;
    category.elements.push_back(query);
    category.truth.push_back(do_meet(query));
    category.has_only_floats = category.has_only_floats && are_floats(query);
  }
  return category;
}

}  // namespace

std::size_t motion_category_count() {
  return kMotionSets;
}

Category<MotionQuery> moving_point_category(std::size_t index, const Sizes& sizes) {
  return motion_category(index, sizes, MotionFeatures::PointAndTriangle);
}

Category<MotionQuery> moving_edge_category(std::size_t index, const Sizes& sizes) {
  return motion_category(index, sizes, MotionFeatures::Edges);
}

}  // namespace graze::benchmark
