#include <gmpxx.h>
#include <graze/bvh/error.h>
#include <graze/engine/mesh/voxel_grid.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "tests/shapes/random_source.h"

namespace graze {
namespace {

/// All that VoxelGrid promises, in rationals where it speaks of one rounding.
void expect_laws(const Aabb& bounds, std::uint32_t resolution) {
  const VoxelGrid grid = VoxelGrid::over(bounds, resolution);
  EXPECT_EQ(grid.origin, bounds.min);
  ASSERT_GT(grid.edge, 0);
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint32_t count = grid.counts[axis];
    ASSERT_GE(count, 1u);
    ASSERT_LE(count, resolution);
    EXPECT_EQ(grid.plane(axis, 0), bounds.min[axis]);
    EXPECT_GE(grid.plane(axis, count), bounds.max[axis]);
    if (count > 1) {
      EXPECT_LT(grid.plane(axis, count - 1), bounds.max[axis]);
    }
    const std::uint32_t step = 1 + count / 100;
    for (std::uint32_t i = 0; i < count; i += step) {
      ASSERT_LT(grid.plane(axis, i), grid.plane(axis, i + 1)) << axis << ' ' << i;
      const mpq_class product = mpq_class(grid.edge) * i;
      ASSERT_TRUE(product == mpq_class(i * grid.edge)) << "so that the sum alone is rounded";
    }
  }
}

TEST(VoxelGrid, CoversBoxesOfAllSizesAndOffsets) {
  RandomSource source(1);
  for (int n = 0; n < 3000; ++n) {
    const double size = std::pow(10.0, source.uniform(-322, 300));
    const double offset = n % 3 == 0 ? 0 : size * std::pow(10.0, source.uniform(-3, 18));
    const Eigen::Vector3d centre = source.vector(-1, 1) * (offset < 1e300 ? offset : 0);
    const Eigen::Vector3d p = centre + source.vector(-1, 1) * size;
    const Eigen::Vector3d q = centre + source.vector(-1, 1) * size;
    Aabb bounds{p.cwiseMin(q), p.cwiseMax(q)};
    if (n % 5 == 0) bounds.max[n % 3] = bounds.min[n % 3];
    if (n % 35 == 0) bounds.max = bounds.min;
    const auto resolution =
        static_cast<std::uint32_t>(n % 2 == 0 ? source.integer(1, 20) : source.integer(1, 65535));
    expect_laws(bounds, resolution);
  }
}

TEST(VoxelGrid, TheLongestSideHasAsManyVoxelsAsAskedFor) {
  RandomSource source(2);
  for (int n = 0; n < 1000; ++n) {
    const Eigen::Vector3d p = source.vector(-1, 1), q = source.vector(-1, 1);
    const auto resolution = static_cast<std::uint32_t>(source.integer(1, 65535));
    const VoxelGrid grid = VoxelGrid::over({p.cwiseMin(q), p.cwiseMax(q)}, resolution);
    EXPECT_EQ(std::max({grid.counts[0], grid.counts[1], grid.counts[2]}), resolution);
  }
}

TEST(VoxelGrid, LatticesStayLattices) {
  const VoxelGrid grid = VoxelGrid::over({{-3, 0, 1}, {5, 2, 1}}, 16);
  EXPECT_EQ(grid.edge, 0.5);
  EXPECT_EQ(grid.counts, (std::array<std::uint32_t, 3>{16, 4, 1}));
  const Aabb box = grid.box({3, 1, 0});
  EXPECT_EQ(box.min, Eigen::Vector3d(-1.5, 0.5, 1));
  EXPECT_EQ(box.max, Eigen::Vector3d(-1, 1, 1.5));
  EXPECT_EQ(grid.size(), 64u);
}

TEST(VoxelGrid, APointHasOneVoxel) {
  for (double at : {0.0, -1.0, 1e9, -1e-310, 1e300}) {
    const Eigen::Vector3d point(at, at, at);
    const VoxelGrid grid = VoxelGrid::over({point, point}, 1000);
    EXPECT_EQ(grid.size(), 1u);
    EXPECT_LT(grid.box({0, 0, 0}).min.x(), grid.box({0, 0, 0}).max.x());
  }
}

std::string error_of(const Aabb& bounds, std::uint32_t resolution) {
  try {
    VoxelGrid::over(bounds, resolution);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Law10VoxelGrid, BadInputIsRefused) {
  const Aabb unit{{0, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(error_of(unit, 0), "resolution: 0 is not from 1 to 65535");
  EXPECT_EQ(error_of(unit, 65536), "resolution: 65536 is not from 1 to 65535");
  EXPECT_EQ(error_of({{0, 0, 0}, {1, std::nan(""), 1}}, 4),
            "voxel grid: bounds: coordinate y is not finite");
  constexpr double kLargest = std::numeric_limits<double>::max();
  EXPECT_EQ(error_of({{-kLargest, 0, 0}, {kLargest, 0, 0}}, 4),
            "voxel grid: the length of the bounds overflows");
  EXPECT_EQ(error_of({{0, 0, 0}, {1, kLargest, 1}}, 3),
            "voxel grid: a plane along y is not finite");
}

TEST(Law10VoxelGrid, GridsMadeByHandAreChecked) {
  const VoxelGrid good{{0, 0, 0}, 1, {1, 2, 3}};
  EXPECT_NO_THROW(good.check());
  VoxelGrid grid = good;
  grid.edge = -1;
  EXPECT_THROW(grid.check(), InputError);
  grid.edge = std::nan("");
  EXPECT_THROW(grid.check(), InputError);
  grid = good;
  grid.counts[1] = 65536;
  EXPECT_THROW(grid.check(), InputError);
  grid.counts[1] = 0;
  EXPECT_THROW(grid.check(), InputError);
  grid = good;
  grid.origin.z() = -std::numeric_limits<double>::infinity();
  EXPECT_THROW(grid.check(), InputError);
}

TEST(Voxel, OrderedByRows) {
  EXPECT_LT((Voxel{65534, 0, 0}), (Voxel{0, 1, 0}));
  EXPECT_LT((Voxel{65534, 65534, 0}), (Voxel{0, 0, 1}));
  EXPECT_LT((Voxel{1, 2, 3}), (Voxel{2, 2, 3}));
  EXPECT_EQ((Voxel{1, 2, 3}), (Voxel{1, 2, 3}));
}

}  // namespace
}  // namespace graze
