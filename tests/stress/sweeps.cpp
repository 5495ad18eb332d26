#include "tests/stress/sweeps.h"

#include <graze/engine/compare/referee.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>

#include "tests/shapes/random_meshes.h"

namespace graze::stress {
namespace {

void judge(const Triangle& a, const Triangle& b, SweepRow& row) {
  const bool truth = compare::referee_intersects(a, b);
  const narrowphase::Decision decision = narrowphase::decide(a, b);
  ++row.cases;
  row.hits += truth;
  row.exact += decision.stage == narrowphase::Stage::Exact;
  row.wrong += decision.is_hit != truth || intersects(b, a) != truth;
}

SweepRow sweep_placed(double value, double scale, double offset, std::size_t cases) {
  RandomSource source(1);
  SweepRow row{.value = value};
  for (std::size_t n = 0; n < cases; ++n) {
    const auto point = [&] { return Eigen::Vector3d(source.lattice_point(-2, 2) * scale); };
    const Triangle a{point(), point(), point()};
    const Triangle b{point(), point(), point()};
    Pose pose = tests::random_pose(offset, source);
    if (n % 4 == 0) pose.linear().setIdentity();
    judge(place(pose, a), place(pose, b), row);
  }
  return row;
}

/// A triangle of length 1 and `width`, its corners rounded.
Triangle needle(double width, RandomSource& source) {
  const Eigen::Vector3d from = source.vector(-1, 1);
  const Eigen::Vector3d along = source.vector(-1, 1).normalized();
  const Eigen::Vector3d across = along.cross(source.vector(-1, 1)).normalized() * width;
  return {from, from + along, from + source.uniform(0, 1) * along + across};
}

/// The triangle moved so that a point of its long edge falls on a point of the other's.
Triangle brought_to(const Triangle& t, const Triangle& other, RandomSource& source) {
  const double u = source.uniform(0, 1);
  const double v = source.uniform(0, 1);
  const Eigen::Vector3d by = other.a + u * (other.b - other.a) - (t.a + v * (t.b - t.a));
  return {t.a + by, t.b + by, t.c + by};
}

}  // namespace

std::vector<SweepRow> sweep_scales(double offset, std::size_t cases) {
  std::vector<SweepRow> rows;
  for (const double scale : {1e-12, 1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9, 1e12})
    rows.push_back(sweep_placed(scale, scale, offset * scale, cases));
  return rows;
}

std::vector<SweepRow> sweep_offsets(std::size_t cases) {
  std::vector<SweepRow> rows;
  for (const double offset : {0.0, 1.0, 1e3, 1e6, 1e9})
    rows.push_back(sweep_placed(offset, 1, offset, cases));
  return rows;
}

std::vector<SweepRow> sweep_needles(std::size_t cases) {
  std::vector<SweepRow> rows;
  for (const double width : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-17}) {
    RandomSource source(1);
    SweepRow row{.value = width};
    for (std::size_t n = 0; n < cases; ++n) {
      const Triangle a = needle(width, source);
      const Triangle b = brought_to(needle(n % 2 == 0 ? width : 0.5, source), a, source);
      judge(a, b, row);
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace graze::stress
