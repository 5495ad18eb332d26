#include "tests/narrowphase/motion/random_clearances.h"

#include <cmath>

namespace graze::tests {
namespace {

int one_of(RandomSource& source, int count) {
  return static_cast<int>(source.integer(0, count - 1));
}

Eigen::Vector3d point(double x, double y, double z) {
  return {x, y, z};
}

PointPath still(const Eigen::Vector3d& p) {
  return {p, p};
}

/// A point, or an edge, that passes a triangle, or an edge at rest, exactly five away at its
/// nearest: from a corner, an edge, a face; or by a hair.
ClearanceQuery passing(RandomSource& source) {
  const double x = static_cast<double>(source.integer(1, 5));
  ClearanceQuery query{{{{point(-x, 3, 4), point(2 * x, 3, 4)},
                         still(point(0, 0, 0)),
                         still(point(-3, -1, -2)),
                         still(point(-2, -2, -5))}},
                       5};
  switch (one_of(source, 3)) {
    case 0:
      break;
    case 1:  // over an edge
      query.paths.path[0] = {point(-x, 0, 5), point(2 * x, 0, 5)};
      query.paths.path[1] = still(point(0, -9, 0));
      query.paths.path[2] = still(point(0, 9, 0));
      query.paths.path[3] = still(point(0, 1, -7));
      break;
    default:  // down to the face, and up again with the triangle
      query.paths.path[0] = {point(0, 0, 5 + x), point(0, 0, 5 - x)};
      query.paths.path[1] = {point(-9, -9, -x), point(-9, -9, x)};
      query.paths.path[2] = {point(9, -9, -x), point(9, -9, x)};
      query.paths.path[3] = {point(0, 9, x), point(0, 9, -3 * x)};
  }
  const int by = one_of(source, 3);
  if (by == 1) query.clearance = std::nextafter(5.0, 4);
  if (by == 2) query.clearance = std::nextafter(5.0, 6);
  return query;
}

/// All goes the same way: near always or never, or at an end.
ClearanceQuery together(RandomSource& source) {
  ClearanceQuery query{random_paths(1, source), 0.5 * static_cast<double>(source.integer(1, 6))};
  const Eigen::Vector3d way = source.lattice_point(-2, 2);
  for (PointPath& path : query.paths.path)
    path.end = path.start + way;
  if (one_of(source, 2) == 0) query.paths.path[0].end += source.lattice_point(-3, 3);
  return query;
}

/// A clearance that is nearly the least distance of a point from a corner.
ClearanceQuery grazing(RandomSource& source) {
  ClearanceQuery query{random_paths(0, source), 0};
  const PointPath &p = query.paths.path[0], &q = query.paths.path[2];
  const Eigen::Vector3d from = p.start - q.start, way = (p.end - q.end) - from;
  const double time = std::min(std::max(-from.dot(way) / way.squaredNorm(), 0.0), 1.0);
  const double more = source.uniform(-1, 1);
  query.clearance = (from + time * way).norm() * (1 + std::ldexp(more, -one_of(source, 54)));
  return query;
}

}  // namespace

bool is_long_clearance_kind(int kind) {
  return kind == 10 || kind == 11;
}

const char* name_of_clearance_kind(int kind) {
  static constexpr const char* kNames[] = {"passing", "together", "grazing"};
  return kind < kPathKinds ? name_of_path_kind(kind) : kNames[kind - kPathKinds];
}

ClearanceQuery random_clearance(int kind, RandomSource& source) {
  if (kind == kPathKinds) return passing(source);
  if (kind == kPathKinds + 1) return together(source);
  if (kind == kPathKinds + 2) return grazing(source);
  const PathQuery paths = random_paths(kind, source);
  double size = 0;
  for (const PointPath& path : paths.path)
    size = std::max(size, path.start.cwiseAbs().maxCoeff());
  switch (one_of(source, 3)) {
    case 0:
      return {paths, std::ldexp(1.0, std::ilogb(size) - 1 - one_of(source, 3))};
    case 1:
      return {paths, size * source.uniform(0.01, 0.4)};
    default:
      return {paths, size * std::ldexp(1.0, -one_of(source, 40) - 1)};
  }
}

}  // namespace graze::tests
