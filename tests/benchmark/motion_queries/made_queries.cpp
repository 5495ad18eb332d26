#include <cmath>

#include "tests/benchmark/motion_queries/queries.h"
#include "tests/narrowphase/motion/random_paths.h"

namespace graze::benchmark {
namespace {

/// Small triangles of two surfaces about z = 0 and z = `gap` that come towards each other a little:
/// features whose swept boxes meet, as a tree over those finds them.
MotionQuery near_query(double gap, double step, bool is_edges, RandomSource& source) {
  PointPath path[4];
  for (int i = 0; i < 4; ++i) {
    const bool is_upper = is_edges ? i < 2 : i < 1;
    Eigen::Vector3d start = source.vector(-1, 1);
    start.z() = start.z() * 0.1 + (is_upper ? gap : 0);
    const Eigen::Vector3d way = step * source.vector(-1, 1);
    const double down = is_upper ? -step : step;
    path[i] = {start, {start.x() + way.x(), start.y() + way.y(), start.z() + down}};
  }
  return MotionQuery::of(path, is_edges);
}

}  // namespace

MotionQuery MotionQuery::of(const PointPath (&path)[4], bool is_edges) {
  MotionQuery query;
  query.is_edges = is_edges;
  query.point = path[0];
  query.triangle = {path[1], path[2], path[3]};
  query.edge_a = {path[0], path[1]};
  query.edge_b = {path[2], path[3]};
  return query;
}

std::vector<MotionSet> made_sets(int count) {
  std::vector<MotionSet> sets;
  RandomSource source(1);
  const auto add_near = [&](const char* name, double gap, double step) {
    MotionSet set{name, {}};
    for (int i = 0; i < count; ++i)
      set.queries.push_back(near_query(gap, step, i % 2 != 0, source));
    sets.push_back(set);
  };
  add_near("meshes, never in one plane", 1, 0.3);
  add_near("meshes, about to meet", 0.4, 0.2);
  add_near("meshes that pass each other", 0.4, 1);
  for (int kind = 0; kind < tests::kPathKinds; ++kind) {
    MotionSet set{tests::name_of_path_kind(kind), {}};
    for (int i = 0; i < count; ++i)
      set.queries.push_back(MotionQuery::of(tests::random_paths(kind, source).path, i % 2 != 0));
    sets.push_back(set);
  }
  return sets;
}

}  // namespace graze::benchmark
