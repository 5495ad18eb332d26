#include "tests/stress/placed_truth.h"

#include <graze/engine/compare/referee.h>
#include <graze/engine/mesh/placement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace graze::stress {
namespace {

struct Placed {
  std::array<Eigen::Vector3d, 3> corner;
  Eigen::Vector3d low;
  Eigen::Vector3d high;
  std::uint32_t index;
};

std::vector<Placed> sorted_along_x(const PlacedMesh& mesh, double margin) {
  std::vector<Placed> placed;
  for (std::uint32_t i = 0; i < mesh.mesh.triangles().size(); ++i) {
    const Triangle t = place(mesh.pose, mesh.mesh.triangle(i));
    Placed p{{t.a, t.b, t.c}, t.a, t.a, i};
    for (const Eigen::Vector3d& corner : p.corner) {
      p.low = p.low.cwiseMin(corner);
      p.high = p.high.cwiseMax(corner);
    }
    p.low.array() -= margin;
    placed.push_back(p);
  }
  std::sort(placed.begin(), placed.end(),
            [](const Placed& a, const Placed& b) { return a.low.x() < b.low.x(); });
  return placed;
}

bool is_gap(const Placed& a, const Placed& b, const Eigen::Vector3d& axis, double margin) {
  const double length = axis.norm();
  if (!(length > 0)) return false;
  double low[2] = {HUGE_VAL, HUGE_VAL};
  double high[2] = {-HUGE_VAL, -HUGE_VAL};
  for (int k = 0; k < 3; ++k) {
    const double x[2] = {a.corner[k].dot(axis), b.corner[k].dot(axis)};
    for (int side = 0; side < 2; ++side) {
      low[side] = std::min(low[side], x[side]);
      high[side] = std::max(high[side], x[side]);
    }
  }
  return std::max(low[0] - high[1], low[1] - high[0]) > margin * length;
}

bool are_apart(const Placed& a, const Placed& b, double margin) {
  std::array<Eigen::Vector3d, 3> edge_a, edge_b;
  for (int k = 0; k < 3; ++k) {
    edge_a[k] = a.corner[(k + 1) % 3] - a.corner[k];
    edge_b[k] = b.corner[(k + 1) % 3] - b.corner[k];
  }
  const Eigen::Vector3d normal_a = edge_a[0].cross(edge_a[1]);
  const Eigen::Vector3d normal_b = edge_b[0].cross(edge_b[1]);
  if (is_gap(a, b, normal_a, margin) || is_gap(a, b, normal_b, margin)) return true;
  for (const Eigen::Vector3d& u : edge_a) {
    if (is_gap(a, b, normal_a.cross(u), margin)) return true;
    for (const Eigen::Vector3d& v : edge_b) {
      if (is_gap(a, b, u.cross(v), margin)) return true;
    }
  }
  return std::any_of(edge_b.begin(), edge_b.end(), [&](const Eigen::Vector3d& v) {
    return is_gap(a, b, normal_b.cross(v), margin);
  });
}

}  // namespace

std::vector<TrianglePair> near_pairs(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b,
                                     double margin) {
  const std::vector<Placed> all_a = sorted_along_x(mesh_a, margin);
  const std::vector<Placed> all_b = sorted_along_x(mesh_b, margin);
  std::vector<TrianglePair> pairs;
  std::vector<const Placed*> open;  // triangles of B that may still overlap along x
  std::size_t next = 0;
  double widest = 0;
  for (const Placed& b : all_b)
    widest = std::max(widest, b.high.x() - b.low.x());
  for (const Placed& a : all_a) {
    while (next < all_b.size() && all_b[next].low.x() <= a.high.x())
      open.push_back(&all_b[next++]);
    std::erase_if(open, [&](const Placed* b) { return b->low.x() + 2 * widest < a.low.x(); });
    for (const Placed* b : open) {
      bool is_overlapping = true;
      for (int k = 0; k < 3; ++k)
        is_overlapping &= a.low[k] <= b->high[k] && b->low[k] <= a.high[k];
      if (is_overlapping && !are_apart(a, *b, margin)) pairs.push_back({a.index, b->index});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool is_any_hit(const std::vector<TrianglePair>& pairs, const PlacedMesh& mesh_a,
                const PlacedMesh& mesh_b) {
  return std::any_of(pairs.begin(), pairs.end(), [&](const TrianglePair& pair) {
    return compare::referee_intersects(place(mesh_a.pose, mesh_a.mesh.triangle(pair.a)),
                                       place(mesh_b.pose, mesh_b.mesh.triangle(pair.b)));
  });
}

}  // namespace graze::stress
