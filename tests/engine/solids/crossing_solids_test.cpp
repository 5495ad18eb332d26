// Open interiors of meshes that go through themselves, touch themselves and lie on themselves:
// tetrahedra by the even-odd rule, beside their half-spaces in whole and in rational numbers.

#include <gmpxx.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/self.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <utility>

#include "tests/engine/solids/half_spaces.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using tests::have_common_volume;
using tests::Tetrahedra;
using Whole = std::int64_t;

/// How triangles turn: as it comes, or all as seen from outside, or none.
enum class Winding { Any, Outward, Inward };

double volume_of(const std::array<tests::PointOf<double>, 4>& corners) {
  std::array<std::array<double, 3>, 3> edges;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      edges[i][k] = corners[i + 1][k] - corners[0][k];
  }
  return tests::dot(tests::cross(edges[0], edges[1]), edges[2]);
}

/// All of them as one mesh.
Mesh mesh_of(const Tetrahedra<double>& solid, Winding winding = Winding::Any) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (const auto& corners : solid) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const auto& corner : corners)
      vertices.emplace_back(corner[0], corner[1], corner[2]);
    for (const TriangleIndices& t : {TriangleIndices{0, 1, 2}, TriangleIndices{0, 3, 1},
                                     TriangleIndices{1, 3, 2}, TriangleIndices{2, 3, 0}}) {
      triangles.push_back({first + t[0], first + t[1], first + t[2]});
      // (0, 1, 2) turns outwards where the fourth corner is behind it.
      const bool is_outward = volume_of(corners) < 0;
      if (winding != Winding::Any && is_outward != (winding == Winding::Outward))
        std::swap(triangles.back()[0], triangles.back()[1]);
    }
  }
  return {vertices, triangles};
}

template <typename Number, typename From>
Tetrahedra<Number> converted(const Tetrahedra<From>& solid, From unit) {
  Tetrahedra<Number> other;
  for (const auto& corners : solid) {
    other.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 3; ++k)
        other.back()[i][k] = static_cast<Number>(unit * corners[i][k]);
    }
  }
  return other;
}

/// With corners on a small lattice, some twice, some sharing corners.
Tetrahedra<double> random_solid(int count, int size, RandomSource& source) {
  Tetrahedra<double> solid;
  while (static_cast<int>(solid.size()) < count) {
    std::array<tests::PointOf<double>, 4> corners;
    if (!solid.empty()) corners = solid.back();
    const int kept = solid.empty() ? 0 : static_cast<int>(source.integer(0, 4));
    for (std::size_t i = static_cast<std::size_t>(kept); i < 4; ++i) {
      const Eigen::Vector3d p = source.lattice_point(0, size);
      corners[i] = {p.x(), p.y(), p.z()};
    }
    if (volume_of(corners) != 0) solid.push_back(corners);
  }
  return solid;
}

bool have_open_set_in_common(const PlacedMeshView& a, const PlacedMeshView& b) {
  const bool is_met = interiors_intersect(a, b);
  EXPECT_EQ(interiors_intersect(b, a), is_met);
  return is_met;
}

void compare_on_a_lattice(std::uint64_t seed, int count) {
  RandomSource source(seed);
  int met = 0, touching = 0, crossing_themselves = 0;
  for (int n = 0; n < count && !testing::Test::HasFailure(); ++n) {
    const int size = 1 + n % 3;
    const auto a = random_solid(n % 16 == 0 ? 3 : 2, size, source);
    const auto b = random_solid(1 + n % 2, size, source);
    const bool is_expected = have_common_volume(converted<Whole>(a, 1.0), converted<Whole>(b, 1.0));
    const double unit = n % 9 == 0 ? 0x1p-300 : n % 9 == 1 ? 0x1p+300 : 1;
    const auto winding = static_cast<Winding>(n / 3 % 3);
    const Mesh mesh_a = mesh_of(converted<double>(a, unit), winding);
    const Mesh mesh_b = mesh_of(converted<double>(b, unit), winding);
    EXPECT_EQ(have_open_set_in_common(mesh_a, mesh_b), is_expected) << n;
    met += is_expected;
    touching += !is_expected && intersects(mesh_a, mesh_b);
    crossing_themselves += !is_expected && !find_self_pairs(mesh_a).pairs.empty();
  }
  EXPECT_GT(met, count / 3);
  EXPECT_GT(touching, count / 4);
  EXPECT_GT(crossing_themselves, count / 4);
}

TEST(InteriorsOfCrossingSolids, AreThoseOfTetrahedraOnALattice) {
  compare_on_a_lattice(71, 350);
}

TEST(InteriorsOfCrossingSolidsSlow, AreThoseOfManyTetrahedraOnALattice) {
  compare_on_a_lattice(73, 8000);
}

/// With corners anywhere, in a pose: on the placed doubles. What B is made of stands on faces of A,
/// so that much touches.
TEST(InteriorsOfCrossingSolids, AreThoseOfPlacedTetrahedra) {
  RandomSource source(72);
  int met = 0, apart = 0;
  for (int n = 0; n < 60; ++n) {
    Tetrahedra<double> solids[2] = {random_solid(2, 2, source), random_solid(2, 2, source)};
    // Two corners less on the lattice; A and B keep others in common.
    for (Tetrahedra<double>& solid : solids) {
      const auto corner = static_cast<std::size_t>(source.integer(0, 3));
      for (std::size_t k = 0; k < 3; ++k)
        solid[0][corner][k] += source.uniform(-0.5, 0.5);
    }
    const Pose pose = tests::random_pose(n % 2 == 0 ? 1 : 1e3, source);
    const Mesh a = mesh_of(solids[0]), b = mesh_of(solids[1]);
    Tetrahedra<mpq_class> exact[2];
    for (std::size_t i = 0; i < 2; ++i) {
      for (const auto& corners : solids[i]) {
        exact[i].emplace_back();
        for (std::size_t j = 0; j < 4; ++j) {
          const Eigen::Vector3d p = narrowphase::place(
              pose, Eigen::Vector3d(corners[j][0], corners[j][1], corners[j][2]));
          exact[i].back()[j] = {mpq_class(p.x()), mpq_class(p.y()), mpq_class(p.z())};
        }
      }
    }
    const bool is_expected = have_common_volume(exact[0], exact[1]);
    EXPECT_EQ(have_open_set_in_common({a, pose}, {b, pose}), is_expected) << n;
    met += is_expected, apart += !is_expected;
  }
  EXPECT_GT(met, 10);
  EXPECT_GT(apart, 5);
}

/// A slab, and walls that stand in it across each other: below each piece of the slab lies nothing.
TEST(InteriorsOfCrossingSolids, AFaceThatManyWallsDivide) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  const auto add = [&](const Eigen::Vector3d& half, const Eigen::Vector3d& middle) {
    const Mesh box = tests::make_box(half);
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const Eigen::Vector3d& vertex : box.vertices())
      vertices.push_back(vertex + middle);
    for (const TriangleIndices& t : box.triangles())
      triangles.push_back({first + t[0], first + t[1], first + t[2]});
  };
  constexpr int kWalls = 6;
  add({16, 16, 1}, {0, 0, 1});  // from 0 to 2
  for (int i = 0; i < kWalls; ++i) {
    const double at = 5.0 * (i - kWalls / 2) + 1.125;
    add({0.25, 14, 2}, {at, 0, 2 - 1.0 / 128});  // both end just below the slab
    add({14, 0.25, 2}, {0, at, 2 - 1.0 / 128});
  }
  const Mesh ribbed(vertices, triangles);
  const Mesh box = tests::make_box({0.5, 0.5, 0.5});
  const auto meets_at = [&](double x, double y, double z) {
    Pose pose = Pose::Identity();
    pose.translation() = Eigen::Vector3d(x, y, z);
    return have_open_set_in_common(ribbed, {box, pose});
  };
  EXPECT_FALSE(meets_at(0, 0, -0.5)) << "against the slab, between walls";
  EXPECT_TRUE(meets_at(1.125, 0, -0.5)) << "a wall comes out below";
  EXPECT_TRUE(meets_at(0, 0, -0.25));
  EXPECT_FALSE(meets_at(0, 0, 2.5)) << "on it, between walls";
  EXPECT_TRUE(meets_at(1.125, 0, 2.5));
}

}  // namespace
}  // namespace graze
