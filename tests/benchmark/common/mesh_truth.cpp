#include "tests/benchmark/common/mesh_truth.h"

#include <graze/engine/compare/referee.h>
#include <graze/engine/mesh/placement.h>

#include <algorithm>

namespace graze::benchmark {
namespace {

struct Placed {
  Triangle triangle;
  Aabb box;
  std::uint32_t index;
};

/// Ascending by the low end along x.
std::vector<Placed> placed_triangles(const Mesh& mesh, const Pose& pose) {
  std::vector<Placed> all;
  for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
    const Triangle t = place(pose, mesh.triangle(i));
    all.push_back({t, {t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)}, i});
  }
  std::sort(all.begin(), all.end(),
            [](const Placed& s, const Placed& t) { return s.box.min.x() < t.box.min.x(); });
  return all;
}

bool do_boxes_meet(const Aabb& a, const Aabb& b) {
  return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

}  // namespace

MeshTruth truth_of(const Mesh& mesh_a, const Mesh& mesh_b, const Pose& pose_b) {
  const std::vector<Placed> all_a = placed_triangles(mesh_a, Pose::Identity());
  const std::vector<Placed> all_b = placed_triangles(mesh_b, pose_b);
  double widest = 0;
  for (const Placed& b : all_b)
    widest = std::max(widest, b.box.max.x() - b.box.min.x());
  MeshTruth truth;
  for (const Placed& a : all_a) {
    // Twice the width covers the rounding of all widths.
    const double from = a.box.min.x() - 2 * widest;
    auto b = std::lower_bound(all_b.begin(), all_b.end(), from,
                              [](const Placed& p, double x) { return p.box.min.x() < x; });
    for (; b != all_b.end() && b->box.min.x() <= a.box.max.x(); ++b) {
      if (!do_boxes_meet(a.box, b->box)) continue;
      ++truth.candidates;
      if (compare::referee_intersects(a.triangle, b->triangle))
        truth.pairs.push_back({a.index, b->index});
    }
  }
  std::sort(truth.pairs.begin(), truth.pairs.end());
  return truth;
}

}  // namespace graze::benchmark
